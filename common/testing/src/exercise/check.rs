//! `Check`: compares a student's code with the lesson.

use std::iter;
use std::panic::{AssertUnwindSafe, catch_unwind};

use common::{Error, Image, Settings, Size};
#[cfg(not(target_family = "wasm"))]
use {
    super::{findings::found_missing, picture},
    common::difference::worst_pixel,
    common::{Stage, divergence, picture_file, steps::with_chosen_pixel},
    program::picture_name,
};

use super::known::{self, Known};
use super::tape::Tape;
use super::{Answer, Input};

/// The change of an input by which right answers may differ, relative to each of its
/// numbers: more than the rounding errors of any right formula, less than an epsilon that
/// anybody would write.
const UNIT: f64 = 1e-9;

/// Some roundings of a number.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Compares the results of a student's code with the right ones.
#[derive(Default)]
pub struct Check {
    pub(super) compared: usize,
    /// Inputs at which the right answer depends on rounding.
    pub(super) skipped: usize,
    pub(super) differ: usize,
    /// The first difference, which is at the simplest input.
    pub(super) first: Option<String>,
    /// A remark on code that is right, as of a picture with the same bytes.
    pub(super) note: Option<String>,
    /// The property that a formula with larger rounding errors lacks.
    pub(super) lacks: Option<&'static str>,
    /// The usual mistakes of the kinds that are compared, and the one that is made to prove
    /// this check.
    pub(super) usual: Vec<&'static str>,
    pub(super) mistake: Option<usize>,
    /// Whether somebody looks at pictures, and at the count of differences.
    pub(super) is_watched: bool,
    /// Whether the code is in a student's file.
    pub(super) is_yours: bool,
    pub(super) picture: Option<Image>,
    /// The answers of the lesson or the solution, with their tolerances, and the student's.
    pub(super) lesson: Tape,
    pub(super) yours: Tape,
    /// The results of the comparisons, if somebody looks; and a student's results while a known
    /// mistake is compared with them.
    pub(super) results: Vec<known::Result>,
    /// The inputs that were found with the solution, which known mistakes get again.
    pub(super) inputs: Vec<Option<Answer>>,
    pub(super) known: Option<Known>,
}

impl Check {
    /// A check, at whose findings somebody looks or not, of code that makes a usual mistake
    /// or not.
    pub(super) fn new(is_watched: bool, mistake: Option<usize>) -> Self {
        Self {
            mistake,
            is_watched,
            ..Self::default()
        }
    }

    /// From now on only some roundings count as right, because the exercise is about
    /// rounding. `lacks` says how code fails that is right but for rounding, as
    /// `loses digits where ...`.
    pub fn exactly(&mut self, lacks: &'static str) {
        self.lacks = Some(lacks);
    }

    /// Names the usual mistakes of a kind, as of all shapes, each with a sentence that a
    /// learner can use. In the runs that prove this check, returns the mistake that
    /// replaces the behaviour of the compared code.
    pub fn usual<F: Copy>(&mut self, mistakes: &[(&'static str, F)]) -> Option<F> {
        self.usual = mistakes.iter().map(|(about, _)| *about).collect();
        Some(mistakes.get(self.mistake?)?.1)
    }

    /// Compares two codes, the lesson's and yours, which `run` calls, at `simple` inputs, and
    /// then at `others`. The words describe an input, with `{}` in the place of each argument.
    ///
    /// Yours is right if it is an answer of the lesson to an input that differs from this
    /// one by rounding: so the tolerance follows from the condition of the input. Where the
    /// lesson itself decides otherwise at such an input, both decisions are right; but
    /// `simple` inputs are numbers like 0, 1 and 2, which every formula computes without
    /// rounding, and at them decisions must be equal, as for a ray that just touches.
    pub fn compare<I: Input, F: Copy, A: Into<Answer>>(
        &mut self,
        words: &str,
        simple: impl IntoIterator<Item = I>,
        others: impl IntoIterator<Item = I>,
        codes: [F; 2],
        run: impl Fn(F, I) -> A,
    ) {
        let run = &run;
        let [lesson, yours] = codes.map(|code| move |input| run(code, input).into());
        if cfg!(target_family = "wasm") {
            return;
        }
        let simple = simple.into_iter().map(|input| (true, input));
        let others = others.into_iter().map(|input| (false, input));
        for (is_simple, input) in simple.chain(others) {
            if !self.compare_at(words, is_simple, &input, &lesson, &yours) {
                return;
            }
        }
    }

    /// Compares at one input, and returns whether the next one matters, too. It is compiled
    /// once for all code with the same kind of input.
    fn compare_at<I: Input>(
        &mut self,
        words: &str,
        is_simple: bool,
        input: &I,
        lesson: &dyn Fn(I) -> Answer,
        yours: &dyn Fn(I) -> Answer,
    ) -> bool {
        let unit = self.lacks.map_or(UNIT, |_| ROUNDING);
        if let Some(known) = &mut self.known {
            return known.compare_at(unit, is_simple, input, yours);
        }
        let Some(right) = self.lesson.next(|| Some(lesson(input.clone()))) else {
            self.conclude(Some("the recorded answers are incomplete".to_owned()));
            return false;
        };
        let run = || catch_unwind(AssertUnwindSafe(|| yours(input.clone()))).ok();
        let got = self.yours.next(run);
        let is_near = |allowed: Vec<f64>| {
            let mut got = got.iter();
            got.any(|got| right.difference(got, &allowed).is_none())
        };
        let is_right = right.tolerances(unit, iter::empty()).is_some_and(is_near);
        // Most answers are near whatever the condition of the input is, and moving it takes time.
        let is_clear = is_simple || is_right && matches!(self.lesson, Tape::Computed);
        let mut allowed = |unit| {
            let moved = input.moved(unit).take_while(|_| !is_clear);
            let moved = moved.map(|pair| pair.map(lesson));
            self.lesson.numbers(|| right.tolerances(unit, moved))
        };
        let strict = self.lacks.map(|_| allowed(ROUNDING));
        let usual = allowed(UNIT);
        let Some(got) = &got else {
            self.results.push(None);
            let panics = "it panics, with the message above";
            self.conclude(Some(described(words, input, panics)));
            return self.is_watched;
        };
        let tolerances = strict.unwrap_or_else(|| usual.clone());
        let Some(tolerances) = tolerances.or_else(|| is_right.then(Vec::new)) else {
            self.skipped += 1;
            self.results.push(None);
            return true;
        };
        let difference = right.difference(got, &tolerances).filter(|_| !is_right);
        let difference = difference.map(|difference| {
            let is_rounding = usual.is_none_or(is_near);
            let about = match self.lacks.filter(|_| is_rounding) {
                Some(it) => format!("{difference}\n    right but for rounding: the formula {it}"),
                None => difference,
            };
            described(words, input, &about)
        });
        self.results.push(Some((got.clone(), difference.is_some())));
        self.conclude(difference);
        self.is_watched || self.differ == 0
    }

    pub(super) fn conclude(&mut self, difference: Option<String>) {
        self.compared += 1;
        self.differ += usize::from(difference.is_some());
        self.first = self.first.take().or(difference);
    }

    /// Renders a scene of the stage with the student's code, and compares the picture
    /// with the locked one. If they differ, the worst pixel is traced by both. After an earlier
    /// failure, only students see the picture.
    #[cfg(not(target_family = "wasm"))]
    pub fn scene(
        &mut self,
        stage: &Stage,
        name: &str,
        render: impl FnOnce(&Settings) -> Result<Image, Error>,
    ) {
        // Unfinished code has no picture.
        let is_shown = self.is_yours && found_missing().is_empty();
        if self.known.is_some() || self.differ > 0 && !is_shown {
            return;
        }
        let compared = stage.scene(name).and_then(|scene| {
            // Four samples show mistakes as well as a hundred.
            let mut settings = scene.defaults.clone();
            settings.samples = settings.samples.min(4);
            let file = picture_name(stage, &scene);
            let locked = if settings.samples == scene.defaults.samples {
                picture::in_book(&file)
            } else {
                picture::of_lesson(&scene, &settings, &file)?
            };
            let expected = picture_file::open(&locked).ok();
            let worst = move |image: &Image| worst_pixel(expected.as_ref()?, image);
            let (image, yours) = with_chosen_pixel(worst, || self.painted(&settings, render));
            let image = self.picture.insert(image?);
            let compared = picture::compare(&locked, image, self.is_watched);
            let is_right = compared.is_ok();
            let mut text = compared.unwrap_or_else(|wrong| wrong);
            if let (Some(yours), Ok(rays), true) =
                (yours, scene.rays(), self.differ > 0 || !is_right)
            {
                let lesson = rays.trace(&settings, yours.pixel)?;
                let parts = lesson.first_divergence(&yours, "yours", divergence::ROUNDING);
                text.extend(parts.map(|parts| format!("\n{parts}")));
            }
            Ok((is_right, text))
        });
        let (is_right, text) = compared.unwrap_or_else(|error| (false, error.to_string()));
        let text = format!("the picture of scene {name}: {text}");
        if self.differ > 0 || is_right {
            self.compared += usize::from(is_right);
            self.note = Some(text);
        } else {
            self.conclude(Some(text));
        }
    }

    /// Adds a remark on code that is right, if somebody looks at it.
    pub fn remark(&mut self, remark: impl FnOnce() -> Result<String, Error>) {
        if self.is_watched && self.differ == 0 {
            let remark = remark().unwrap_or_else(|error| error.to_string());
            let notes = self.note.take().into_iter().chain([remark]);
            self.note = Some(notes.collect::<Vec<_>>().join("\n"));
        }
    }

    /// Paints a small picture with the student's code, if somebody looks at it. After a failure,
    /// only students see it.
    pub fn picture(&mut self, paint: impl FnOnce(&Settings) -> Result<Image, Error>) {
        if !self.is_watched || self.differ > 0 && !self.is_yours {
            return;
        }
        let painted = Size::new(320, 240).map_err(Error::from).and_then(|size| {
            let settings = Settings::default();
            paint(&Settings { size, ..settings })
        });
        match painted {
            Ok(image) => self.picture = Some(image),
            Err(error) => self.conclude(Some(format!("a picture: {error}"))),
        }
    }
}

/// An input in words, and a sentence about it.
fn described(words: &str, input: &impl Input, about: &str) -> String {
    let (mut shown, mut pieces) = (String::new(), words.split("{}"));
    for argument in input.words() {
        shown += pieces.next().unwrap_or_default();
        shown += &argument;
    }
    format!("{shown}{}:\n    {about}", pieces.collect::<String>())
}
