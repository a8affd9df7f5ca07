//! Error against run time, measured on the page: by the experiments of the reports, step by step, because
//! the page shows each point at once, says how long it still takes, and has the clock.
//!
//! A page begins a measurement of some methods, asks for `prepare` until it is prepared, and then, for each
//! turn, for `run`, whose time it takes and tells to `took`.

mod edges;
mod pictures;

use std::cell::RefCell;
use std::fmt::Write;

use common::{Color, Error, Image, Size};
use measure::front::Contender;
use measure::report::Measured;
use measure::scene_report::METHODS;
use measure::{Rounds, Turn, time_to_error};

use crate::{Answered, Reply, omissions};
use pictures::Pictures;

/// A measurement that has begun.
struct Measuring {
    subject: Subject,
    /// None until everything is prepared.
    timed: Option<Timed>,
    least_time: f64,
    work_done: f64,
}

/// What is measured.
enum Subject {
    /// The samples of a picture.
    Pictures(Pictures),
    /// The experiment of this name, with edges.
    Edges(String),
    /// A picture without some omissions.
    LeftOut,
}

/// The points that take turns.
struct Timed {
    measured: Measured<'static>,
    rounds: Rounds,
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
        let measuring = Measuring::begin(&methods, name, numbers)?;
        let answer = measuring.progress();
        MEASURING.set(Some(measuring));
        return Ok(answer);
    }
    MEASURING.with_borrow_mut(|measuring| match measuring {
        Some(measuring) => measuring.answer(request, numbers),
        None => Err(Error::Usage("no measurement has begun".to_owned())),
    })
}

fn flag(is_set: bool) -> f64 {
    u8::from(is_set).into()
}

/// The least number of samples per pixel, from this one on, that a method can take.
fn next_samples(method: &str, samples: f64) -> f64 {
    let known = METHODS.iter().find(|known| known.name == method);
    known.map_or_else(|| samples.ceil(), |known| known.next(samples))
}

impl Measuring {
    fn begin(methods: &[&str], name: &str, numbers: &[f64]) -> Result<Self, Error> {
        let (subject, measured) = if let Some(picture) = name.strip_prefix("left-out ") {
            let settings = numbers.get(1..).unwrap_or_default();
            let measured = omissions::measured(picture, settings)?;
            (Subject::LeftOut, Some(measured))
        } else if let Some(measured) = edges::measured(name, methods) {
            (Subject::Edges(name.to_owned()), Some(measured))
        } else {
            (Subject::Pictures(Pictures::new(name, methods)?), None)
        };
        let mut measuring = Self {
            subject,
            timed: None,
            least_time: numbers.first().copied().unwrap_or(1e-3),
            work_done: 0.0,
        };
        if let Some(measured) = measured {
            measuring.take_turns(measured);
        }
        Ok(measuring)
    }

    fn answer(&mut self, request: &str, numbers: &[f64]) -> Answered {
        match (request, numbers) {
            ("prepare", _) => {
                self.prepare();
                Ok(self.progress())
            }
            ("run", _) => {
                if let Some(Timed { measured, rounds }) = &mut self.timed
                    && let Some(turn) = rounds.turn()
                {
                    measured.run(turn);
                }
                Ok(Reply::default())
            }
            ("took", [seconds]) => {
                self.took(*seconds);
                Ok(self.with_points(self.progress()))
            }
            ("soonest", [error]) => Ok(self.soonest(*error)),
            ("picture", [curve, point]) => self.picture(*curve as usize, *point as usize),
            _ => Err(Error::Usage(format!("a measurement has no \"{request}\""))),
        }
    }

    fn prepare(&mut self) {
        if let (Subject::Pictures(pictures), None) = (&mut self.subject, &self.timed) {
            self.work_done += pictures.prepare();
            if let Some(measured) = pictures.measured() {
                self.take_turns(measured);
            }
        }
    }

    fn take_turns(&mut self, measured: Measured<'static>) {
        let rounds = Rounds::new(&measured.curves, ROUNDS, self.least_time);
        self.timed = Some(Timed { measured, rounds });
    }

    fn took(&mut self, seconds: f64) {
        let Some(Timed { measured, rounds }) = &mut self.timed else {
            return;
        };
        if let Some(Turn { curve, point, .. }) = rounds.turn() {
            let [before, _] = rounds.progress();
            rounds.took(seconds);
            if rounds.progress()[0] > before {
                self.work_done += self.subject.work(curve, point);
            }
            measured.set_times(rounds);
        }
    }

    /// How much is done of how much, in samples per pixel; whether all is prepared, and whether all is measured.
    fn progress(&self) -> Reply {
        let points: f64 = match (&self.subject, &self.timed) {
            (Subject::Pictures(pictures), _) => pictures.work_of_a_round(),
            (_, Some(timed)) => timed.measured.points().count() as f64,
            (_, None) => 0.0,
        };
        let before = match &self.subject {
            Subject::Pictures(pictures) => pictures.work_to_prepare(),
            _ => 0.0,
        };
        let rounds = self.timed.as_ref().map(|timed| &timed.rounds);
        Reply::default()
            .with(
                "progress",
                [self.work_done, before + ROUNDS as f64 * points],
            )
            .with("prepared", [flag(rounds.is_some())])
            .with(
                "measured",
                [flag(rounds.is_some_and(|rounds| rounds.turn().is_none()))],
            )
            .with("rounds", [rounds.map_or(0, Rounds::whole_rounds) as f64])
            .with(
                "too_short",
                [flag(rounds.is_some_and(Rounds::is_too_short))],
            )
    }

    /// The answer with a row for each point: its place, error and time with their ends, and whether it is on the
    /// front. The text has a line for each curve: its name, its slope, and how long its first point takes beside
    /// that of the first curve.
    fn with_points(&self, answer: Reply) -> Reply {
        let Some(Timed { measured, .. }) = &self.timed else {
            return answer;
        };
        let mut text = "method\tslope\tquotient".to_owned();
        for curve in &measured.curves {
            let slope = measured.experiment.fit(curve).map(|fit| fit.to_string());
            let first = curve.points.first();
            let quotient = first.and_then(|first| first.times.over_first);
            let [slope, quotient] =
                [slope, quotient.map(|median| median.to_string())].map(Option::unwrap_or_default);
            let _ = write!(text, "\n{}\t{slope}\t{quotient}", curve.method);
        }
        let front = measured.front(None);
        let rows = measured.points().map(|(curve, point)| {
            let is_point = |one: &Contender| one.curve == curve && one.parameter == point.parameter;
            let (error, time) = (&point.errors, &point.times.seconds);
            [
                ("point.curve", curve as f64),
                ("point.parameter", point.parameter),
                ("point.work", point.work),
                ("point.error", error.rms),
                ("point.error_low", error.interval.low),
                ("point.error_high", error.interval.high),
                ("point.seconds", time.value),
                ("point.seconds_low", time.low),
                ("point.seconds_high", time.high),
                ("point.front", flag(front.iter().any(is_point))),
            ]
        });
        Reply { text, ..answer }.with_rows(rows)
    }

    /// The methods that reach an error, the soonest first, and how many may be the soonest.
    fn soonest(&self, error: f64) -> Reply {
        let curves = self.timed.as_ref().map(|timed| &timed.measured.curves[..]);
        let (times, ties) = time_to_error::soonest(curves.unwrap_or_default(), error, next_samples);
        let rows = times.iter().map(|found| {
            [
                ("reach.curve", found.curve as f64),
                ("reach.parameter", found.parameter),
                ("reach.seconds", found.time.value),
                ("reach.seconds_low", found.time.low),
                ("reach.seconds_high", found.time.high),
            ]
        });
        Reply::default().with("ties", [ties as f64]).with_rows(rows)
    }

    /// The picture of a point, and beside it its errors, enlarged.
    fn picture(&self, curve: usize, point: usize) -> Answered {
        let missing = || Error::Usage("there is no such point".to_owned());
        let curves = self.timed.as_ref().map(|timed| &timed.measured.curves);
        let of = curves.and_then(|curves| curves.get(curve));
        let of = of.filter(|curve| point < curve.points.len());
        let of = of.ok_or_else(missing)?;
        let rms = of.points[point].errors.rms;
        let shown = match &self.subject {
            Subject::Pictures(pictures) => pictures.picture(of.method, point)?,
            Subject::Edges(name) => edges::picture(name, of.method, point)?,
            Subject::LeftOut => return Err(missing()),
        };
        shown.beside_its_errors(rms)
    }
}

impl Subject {
    /// The work of a turn, in samples per pixel; of others than pictures each turn takes as long as every other,
    /// because it is repeated until it does.
    fn work(&self, curve: usize, point: usize) -> f64 {
        match self {
            Self::Pictures(pictures) => pictures.work(curve, point),
            _ => 1.0,
        }
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
