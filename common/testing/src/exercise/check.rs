//! `Check`: compares the results of a student's code with the right ones.

use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Settings, Size, Transfer, picture_file};
use measure::Stage;
use measure::extremes::{Bound, Case, Outcome};

use super::locked;

/// The parts that the running check has found missing.
static MISSING: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// A placeholder in a starter for the student's code; returns `for_now`. The check
/// that calls it reports once that `what` is missing.
pub fn missing<T>(what: &str, for_now: T) -> T {
    let mut missing = MISSING.lock().unwrap_or_else(PoisonError::into_inner);
    if !missing.iter().any(|known| known == what) {
        missing.push(what.to_owned());
    }
    for_now
}

/// Compares the results of the student's code with the right ones.
#[derive(Default)]
pub struct Check {
    compared: usize,
    /// The last comparison, after which a panic happens.
    last: String,
    wrong: Vec<String>,
    pictures: Pictures,
}

/// The files of the picture that a check makes.
#[derive(Default)]
pub(super) struct Pictures {
    /// Where to save it, if at all.
    pub left: Option<PathBuf>,
    /// The same picture in the book, if it shows one.
    pub shown: Option<PathBuf>,
}

impl Check {
    /// Compares an outcome with the exact one: the name of the quantity, its exact
    /// value, the largest error that counts as right, and the result of the student's
    /// code.
    pub fn expect(
        &mut self,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        got: impl Into<Outcome>,
    ) {
        let case = Case::new("", what, exact, bound, got);
        let wrong = format!("{}: {}", case.what, case.comparison());
        self.last.clone_from(&case.what);
        self.conclude(case.holds().then_some(()).ok_or(wrong));
    }

    fn conclude(&mut self, result: Result<(), impl Display>) {
        self.compared += 1;
        self.wrong
            .extend(result.err().map(|wrong| wrong.to_string()));
    }

    /// Renders a scene of the stage with the student's code, and compares the picture
    /// with the locked one, unless an earlier comparison of this check has failed: then
    /// the numbers say more.
    pub fn scene(
        &mut self,
        stage: &Stage,
        scene: &str,
        render: impl FnOnce(&Settings) -> Result<Image, Error>,
    ) {
        if self.wrong.is_empty() {
            let left = self.pictures.left.take();
            self.conclude(locked::compare(stage, scene, render, left));
        }
    }

    /// Saves a small picture made with the student's code. The picture of the solution
    /// is compared with the one in the book.
    pub fn picture(&mut self, paint: impl FnOnce(&Settings) -> Result<Image, Error>) {
        let Pictures { left, shown } = std::mem::take(&mut self.pictures);
        if left.is_some() || shown.is_some() {
            let result = small(paint).and_then(|image| leave_and_compare(&image, left, shown));
            match result {
                Ok(same) => self.expect("the picture is the book's", true, Bound::Equal, same),
                Err(error) => self.conclude(Err(format!("a picture: {error}"))),
            }
        }
    }
}

fn small(paint: impl FnOnce(&Settings) -> Result<Image, Error>) -> Result<Image, Error> {
    paint(&Settings {
        size: Size::new(320, 240)?,
        ..Settings::default()
    })
}

/// Saves a picture, and returns whether it equals the one in the book, if there is
/// one.
fn leave_and_compare(
    image: &Image,
    left: Option<PathBuf>,
    shown: Option<PathBuf>,
) -> Result<bool, Error> {
    let rgb = image.to_rgb8(Transfer::Linear);
    if let Some(path) = left {
        picture_file::save_png(&path, image.size(), &rgb)?;
        println!("picture: {}", path.display());
    }
    let shown = shown.map(|path| picture_file::open(&path)).transpose()?;
    Ok(shown.is_none_or(|shown| shown.to_rgb8(Transfer::Linear) == rgb))
}

/// The findings of a check.
pub(super) struct Findings {
    /// The missing parts of the code.
    pub missing: Vec<String>,
    /// The differences, with their errors.
    pub wrong: Vec<String>,
}

/// Number of differences that are reported in full.
const MAX_REPORTED: usize = 3;

impl Findings {
    /// Runs a check.
    pub fn of(run: fn(&mut Check), pictures: Pictures) -> Self {
        let take_missing =
            || std::mem::take(&mut *MISSING.lock().unwrap_or_else(PoisonError::into_inner));
        take_missing();
        let mut check = Check {
            pictures,
            ..Check::default()
        };
        let panicked = catch_unwind(AssertUnwindSafe(|| run(&mut check))).is_err();

        let mut wrong = Vec::new();
        if panicked {
            let last = &check.last;
            wrong.push(format!("it panics, with the message above, after: {last}"));
        }
        let compared = check.compared;
        if compared == 0 {
            wrong.push("nothing is compared".to_owned());
        }
        if !check.wrong.is_empty() {
            let differ = check.wrong.len();
            wrong.push(format!("{differ} of {compared} comparisons differ"));
        }
        // The text before a semicolon is the kind of a comparison; one of each is enough.
        let mut kinds = Vec::new();
        check.wrong.retain(|line| {
            let kind = line.split(';').next().map(str::to_owned);
            let is_new = !kinds.contains(&kind);
            kinds.push(kind);
            is_new
        });
        wrong.extend(check.wrong.into_iter().take(MAX_REPORTED));
        Self {
            missing: take_missing(),
            wrong,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(run: fn(&mut Check)) -> (String, String) {
        let Findings { missing, wrong } = Findings::of(run, Pictures::default());
        (missing.join("; "), wrong.join("; "))
    }

    /// One test for all, because checks share the list of missing parts.
    #[test]
    fn a_check_finds_missing_parts_and_differences() {
        let right = found(|check| check.expect("two", 2.0, Bound::Equal, 2.0));
        assert_eq!(right, (String::new(), String::new()));

        let (lacks, wrong) = found(|check| {
            for exact in 1..=2 {
                let got = missing("the number", 1.0);
                check.expect("a number", f64::from(exact), Bound::Equal, got);
            }
        });
        assert_eq!(lacks, "the number", "once");
        assert!(wrong.starts_with("1 of 2 comparisons differ"), "{wrong}");
        assert!(
            wrong.contains("a number: expected 2, got 1, off by 1"),
            "{wrong}"
        );

        let (_, wrong) = found(|_| std::panic::resume_unwind(Box::new("the student's code")));
        assert!(wrong.contains("panics"), "{wrong}");
        let (_, wrong) = found(|_| ());
        assert!(wrong.contains("nothing"), "{wrong}");
    }
}
