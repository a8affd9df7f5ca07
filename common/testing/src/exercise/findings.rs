//! `Findings`: the missing parts of a student's code, and its errors.

use std::collections::HashSet;
use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError};

use common::Image;

use super::Check;

/// The parts that the running check has found missing.
fn found_missing() -> MutexGuard<'static, Vec<String>> {
    static MISSING: Mutex<Vec<String>> = Mutex::new(Vec::new());
    MISSING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A placeholder in a starter for the student's code; returns `for_now`. The check
/// that calls it reports once that `what` is missing.
pub fn missing<T>(what: &str, for_now: T) -> T {
    let mut missing = found_missing();
    if !missing.iter().any(|known| known == what) {
        missing.push(what.to_owned());
    }
    for_now
}

/// The findings of a check.
pub(super) struct Findings {
    /// The missing parts of the code.
    pub missing: Vec<String>,
    /// Messages about errors.
    pub wrong: Vec<String>,
    /// The picture that the code has made.
    pub picture: Option<Image>,
}

/// Number of differences that are reported in full.
const MAX_REPORTED: usize = 3;

impl Findings {
    /// Runs a check. Unless it `is_watched`, it makes no pictures that are only looked at.
    pub fn of(run: fn(&mut Check), is_watched: bool) -> Self {
        found_missing().clear();
        let mut check = Check {
            is_watched,
            last: "the start".to_owned(),
            ..Check::default()
        };
        let panicked = catch_unwind(AssertUnwindSafe(|| run(&mut check))).is_err();
        let (compared, last) = (check.compared, check.last);
        let mut wrong = Vec::new();
        if panicked {
            wrong.push(format!("it panics, with the message above, after: {last}"));
        } else if compared == 0 {
            wrong.push("nothing is compared".to_owned());
        }
        if !check.wrong.is_empty() {
            let differ = check.wrong.len();
            wrong.push(format!("{differ} of {compared} comparisons differ"));
        }
        // The text before a semicolon is the kind of a comparison; one of each is enough.
        let mut kinds = HashSet::new();
        let firsts = check.wrong.iter();
        let firsts = firsts.filter(|line| kinds.insert(line.split(';').next()));
        wrong.extend(firsts.take(MAX_REPORTED).cloned());
        Self {
            missing: mem::take(&mut found_missing()),
            wrong,
            picture: check.picture,
        }
    }
}

#[cfg(test)]
mod tests {
    use measure::extremes::Bound;

    use super::*;

    fn found(run: fn(&mut Check)) -> (String, String) {
        let Findings { missing, wrong, .. } = Findings::of(run, false);
        (missing.join("; "), wrong.join("; "))
    }

    /// One test for all, because checks share the list of missing parts.
    #[test]
    fn a_check_finds_missing_parts_and_differences() {
        let right = found(|check| check.expect("two", 2.0, Bound::Equal, 2.0));
        assert_eq!(right, (String::new(), String::new()));

        let (lacks, wrong) = found(|check| {
            for exact in [1.0, 2.0] {
                let got = missing("the number", 1.0);
                check.expect("a number", exact, Bound::Equal, got);
            }
        });
        assert_eq!(lacks, "the number", "once");
        let expected = "1 of 2 comparisons differ; a number: expected 2, got 1, off by 1";
        assert!(wrong.starts_with(expected), "{wrong}");

        let (_, wrong) = found(|_| std::panic::resume_unwind(Box::new("the student's code")));
        assert!(wrong.contains("panics"), "{wrong}");
        let (_, wrong) = found(|_| ());
        assert_eq!(wrong, "nothing is compared");
    }
}
