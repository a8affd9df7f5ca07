//! `Check`: compares what a student's code computes with what is right.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Settings, Size, Transfer, picture_file};
use measure::extremes::{Bound, Case, Outcome};

/// What the running check has found missing.
static MISSING: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Stands in a starter for what the student is to write, and is `for_now`. The
/// check, which meets it, says once that `what` is missing.
pub fn missing<T>(what: &str, for_now: T) -> T {
    let mut missing = MISSING.lock().unwrap_or_else(PoisonError::into_inner);
    if !missing.iter().any(|known| known == what) {
        missing.push(what.to_owned());
    }
    for_now
}

/// Compares what the student's code computes with what is right.
#[derive(Default)]
pub struct Check {
    compared: Vec<Case>,
    pictures: Pictures,
}

/// What is done with the picture that a check makes.
#[derive(Default)]
pub(super) struct Pictures {
    /// Where it goes, if it is wanted.
    pub left: Option<PathBuf>,
    /// Where the same picture must be, if the book shows it.
    pub shown: Option<PathBuf>,
}

impl Check {
    /// Compares an outcome with the exact one: what is computed, its exact value,
    /// how far off is right, and what the student's code makes of it.
    pub fn expect(
        &mut self,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        got: impl Into<Outcome>,
    ) {
        self.compared.push(Case::new("", what, exact, bound, got));
    }

    /// Leaves a small picture made with the student's code, if this exercise was
    /// asked for by name. The solution's is compared with the one in the book.
    pub fn picture(&mut self, paint: impl FnOnce(&Settings) -> Result<Image, Error>) {
        let Pictures { left, shown } = std::mem::take(&mut self.pictures);
        if left.is_none() && shown.is_none() {
            return;
        }
        match small(paint).and_then(|image| leave_and_compare(&image, left, shown)) {
            Ok(same) => self.expect("the picture is the book's", true, Bound::Equal, same),
            Err(error) => self.expect(format!("a picture: {error}"), true, Bound::Equal, false),
        }
    }
}

fn small(paint: impl FnOnce(&Settings) -> Result<Image, Error>) -> Result<Image, Error> {
    paint(&Settings {
        size: Size::new(320, 240)?,
        ..Settings::default()
    })
}

/// Whether a picture is the one shown, if there is one.
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

/// What a check finds.
pub(super) struct Findings {
    /// What the code still lacks.
    pub missing: Vec<String>,
    /// What differs, and how far off it is.
    pub wrong: Vec<String>,
}

/// How many differences are told in full.
const TOLD: usize = 3;

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
            wrong.push("it panics, with the message above".to_owned());
        }
        let compared = check.compared.len();
        if compared == 0 {
            wrong.push("nothing is compared".to_owned());
        }
        let differ: Vec<_> = check.compared.iter().filter(|case| !case.holds()).collect();
        if !differ.is_empty() {
            wrong.push(format!("{} of {compared} comparisons differ", differ.len()));
        }
        let told = differ.iter().take(TOLD);
        wrong.extend(told.map(|case| format!("{}: {}", case.what, case.comparison())));
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

    /// One test: what is missing is kept in one place for all.
    #[test]
    fn a_check_finds_what_is_missing_and_what_differs() {
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
