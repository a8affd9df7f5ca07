//! Error against run time, measured on the page: by the experiments of the reports, step by step, because
//! the page shows each point at once, says how long it still takes, and has the clock.
//!
//! A page begins a measurement of some methods, asks for `prepare` until it is prepared, and then, for each
//! turn, for `run`, whose time it takes and tells to `took`.

mod edges;
mod pictures;

use std::cell::RefCell;

use common::{Color, Error, Image, Size};
use measure::experiment::Point;
use measure::front::Contender;
use measure::report::Measured;
use measure::{Rounds, Turn, reach};

use crate::{Answer, Answered, omissions};
use pictures::Pictures;

/// A measurement that has begun.
struct Measuring {
    /// The name of the experiment or of the picture.
    name: String,
    /// None of an experiment with edges.
    pictures: Option<Pictures>,
    /// None until everything is prepared.
    timed: Option<(Measured<'static>, Rounds)>,
    least_time: f64,
    work_done: f64,
}

/// A picture, and by how much its channels are too bright.
struct Shown {
    image: Image,
    errors: Vec<f64>,
}

/// The rounds in which the methods take turns, as in a report.
const ROUNDS: usize = 9;

thread_local! {
    static MEASURING: RefCell<Option<Measuring>> = const { RefCell::new(None) };
}

/// Answers `begin METHODS|SUBJECT` with the least time in seconds that the clock can tell, and requests to
/// the measurement that has begun. The subject `left-out PICTURE` has its own methods, and further numbers.
pub fn answer(request: &str, numbers: &[f64]) -> Answered {
    if let Some((methods, name)) = request
        .strip_prefix("begin ")
        .and_then(|words| words.split_once('|'))
    {
        let methods: Vec<_> = methods.split(',').collect();
        let mut measuring = Measuring {
            name: name.to_owned(),
            pictures: None,
            timed: None,
            least_time: numbers.first().copied().unwrap_or(1e-3),
            work_done: 0.0,
        };
        if let Some(picture) = name.strip_prefix("left-out ") {
            let settings = numbers.get(1..).unwrap_or_default();
            measuring.take_turns(omissions::measured(picture, settings)?);
        } else if let Some(measured) = edges::measured(name, &methods) {
            measuring.take_turns(measured);
        } else {
            measuring.pictures = Some(Pictures::new(name, &methods)?);
        }
        let answer = measuring.progress();
        MEASURING.set(Some(measuring));
        return Ok(answer);
    }
    MEASURING.with_borrow_mut(|measuring| {
        let begun = measuring.as_mut();
        let begun = begun.ok_or_else(|| Error::Usage("no measurement has begun".to_owned()))?;
        match (request, numbers) {
            ("prepare", _) => {
                begun.prepare();
                Ok(begun.progress())
            }
            ("run", _) => {
                if let Some((measured, rounds)) = &mut begun.timed
                    && let Some(turn) = rounds.turn()
                {
                    measured.run(turn);
                }
                Ok(Answer::default())
            }
            ("took", [seconds]) => {
                begun.took(*seconds);
                Ok(begun.points(begun.progress()))
            }
            ("soonest", [error]) => Ok(begun.soonest(*error)),
            ("picture", [curve, point]) => begun.picture(*curve as usize, *point as usize),
            _ => Err(Error::Usage(format!("a measurement has no \"{request}\""))),
        }
    })
}

impl Measuring {
    fn prepare(&mut self) {
        if let Some(pictures) = self.pictures.as_mut().filter(|_| self.timed.is_none()) {
            self.work_done += pictures.prepare();
            if let Some(measured) = pictures.measured() {
                self.take_turns(measured);
            }
        }
    }

    fn take_turns(&mut self, measured: Measured<'static>) {
        let rounds = Rounds::new(&measured.curves, ROUNDS, self.least_time);
        self.timed = Some((measured, rounds));
    }

    /// The work of a turn, in samples per pixel; of edges each turn is repeated until it takes as long as
    /// others.
    fn work(&self, point: &Point) -> f64 {
        match self.pictures {
            Some(_) => point.parameter + 1.0,
            None => 1.0,
        }
    }

    fn took(&mut self, seconds: f64) {
        let Some((mut measured, mut rounds)) = self.timed.take() else {
            return;
        };
        if let Some(Turn { curve, point, .. }) = rounds.turn() {
            let [before, _] = rounds.progress();
            rounds.took(seconds);
            if rounds.progress()[0] > before {
                self.work_done += self.work(&measured.curves[curve].points[point]);
            }
            measured.set_times(&rounds);
        }
        self.timed = Some((measured, rounds));
    }

    /// How much is done of how much, whether all is prepared, and whether all is measured.
    fn progress(&self) -> Answer {
        let mut work = self
            .pictures
            .as_ref()
            .map_or(0.0, Pictures::work_to_prepare);
        let flag = |is_set| f64::from(u8::from(is_set));
        let mut rounds_done = 0;
        let (mut is_measured, mut is_too_short) = (false, false);
        if let Some((measured, rounds)) = &self.timed {
            let points = measured.curves.iter().flat_map(|curve| &curve.points);
            work += ROUNDS as f64 * points.map(|point| self.work(point)).sum::<f64>();
            (rounds_done, is_measured) = (rounds.whole_rounds(), rounds.turn().is_none());
            is_too_short = rounds.is_too_short();
        }
        Answer::default()
            .with("progress", [self.work_done, work])
            .with("prepared", [flag(self.timed.is_some())])
            .with("measured", [flag(is_measured)])
            .with("rounds", [rounds_done as f64])
            .with("too_short", [flag(is_too_short)])
    }

    /// Each list has a number for each point: its place, error and time with their ends, and whether it
    /// is on the front. As text, the name of each curve, its slope, and how long its first point takes beside that
    /// of the first curve.
    fn points(&self, answer: Answer) -> Answer {
        let Some((measured, _)) = &self.timed else {
            return answer;
        };
        let front = measured.front(None);
        let mut lists = [const { Vec::new() }; 10];
        let mut lines = Vec::new();
        for (c, curve) in measured.curves.iter().enumerate() {
            let fit = measured.experiment.fit(curve);
            let slope = fit.map(|fit| fit.to_string()).unwrap_or_default();
            let quotient = curve
                .points
                .first()
                .and_then(|first| first.times.over_first);
            let quotient = quotient
                .map(|median| median.to_string())
                .unwrap_or_default();
            lines.push(format!("{}\t{slope}\t{quotient}", curve.method));
            for point in &curve.points {
                let is_point = |one: &Contender| one.curve == c && one.parameter == point.parameter;
                let is_on_front = u8::from(front.iter().any(is_point));
                let (error, time) = (&point.errors, &point.times.seconds);
                let numbers = [
                    c as f64,
                    point.parameter,
                    point.work,
                    error.rms,
                    error.interval.low,
                    error.interval.high,
                    time.value,
                    time.low,
                    time.high,
                    is_on_front.into(),
                ];
                for (list, number) in lists.iter_mut().zip(numbers) {
                    list.push(number);
                }
            }
        }
        let names = [
            "curve",
            "parameter",
            "work",
            "error",
            "error_low",
            "error_high",
            "seconds",
            "seconds_low",
            "seconds_high",
            "front",
        ];
        let mut answer = Answer {
            text: lines.join("\n"),
            ..answer
        };
        answer.numbers.extend(names.into_iter().zip(lists));
        answer
    }

    /// The methods that reach an error, the soonest first, and how many may be the soonest.
    fn soonest(&self, error: f64) -> Answer {
        let curves = self
            .timed
            .as_ref()
            .map(|(measured, _)| &measured.curves[..]);
        let (reaches, ties) = reach::soonest(curves.unwrap_or_default(), error);
        let of =
            |number: fn(&reach::Reach) -> f64| -> Vec<f64> { reaches.iter().map(number).collect() };
        Answer::default()
            .with("ties", [ties as f64])
            .with("curve", of(|one| one.curve as f64))
            .with("parameter", of(|one| one.parameter))
            .with("seconds", of(|one| one.time.value))
            .with("seconds_low", of(|one| one.time.low))
            .with("seconds_high", of(|one| one.time.high))
    }

    /// The picture of a point, and beside it its errors, enlarged.
    fn picture(&self, curve: usize, point: usize) -> Answered {
        let missing = || Error::Usage("there is no such point".to_owned());
        let curves = self.timed.as_ref().map(|(measured, _)| &measured.curves);
        let of = curves.and_then(|curves| curves.get(curve));
        let of = of.filter(|curve| point < curve.points.len());
        let of = of.ok_or_else(missing)?;
        let rms = of.points[point].errors.rms;
        let shown = match &self.pictures {
            Some(pictures) => pictures.picture(of.method, point)?,
            None => edges::picture(&self.name, of.method, point)?,
        };
        shown.beside_its_errors(rms)
    }
}

impl Shown {
    /// The picture, and beside it how far each channel is off: grey is right, lighter is too bright. The errors
    /// are enlarged by a power of two that makes their root mean square an eighth or more.
    fn beside_its_errors(&self, rms: f64) -> Answered {
        let factor = if rms > 0.0 {
            libm::exp2(libm::ceil(libm::log2(0.125 / rms))).max(1.0)
        } else {
            1.0
        };
        let size = self.image.size();
        let (width, height) = (size.width(), size.height());
        let enlarged = Image::from_fn(size, |x, y| {
            let pixel = 3 * (y * width + x) as usize;
            let [r, g, b] = [0, 1, 2].map(|channel| 0.5 + factor * self.errors[pixel + channel]);
            Color::new(r, g, b)
        })?;
        let mut both = Image::black(Size::new(2 * width, height)?)?;
        both.paste(0, 0, &self.image);
        both.paste(width, 0, &enlarged);
        Ok(crate::picture::pixels(&both).with("factor", [factor]))
    }
}
