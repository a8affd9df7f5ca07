//! `Findings`: the missing parts of a student's code, and its errors.

use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::{Answer, Check, Code};

/// The parts that the running check has found missing.
pub(super) fn found_missing() -> MutexGuard<'static, Vec<String>> {
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

/// An assertion of an example, of numbers that formulas may round differently.
#[track_caller]
pub fn assert_close(yours: impl Into<Answer>, right: impl Into<Answer>) {
    let (yours, right) = (yours.into(), right.into());
    let allowed = right.numbers().map(|(_, largest)| largest.max(1e-3) * 1e-9);
    let difference = right.difference(&yours, &allowed.collect::<Vec<_>>());
    assert!(difference.is_none(), "{}", difference.unwrap_or_default());
}

/// The findings of a check.
#[derive(Default)]
pub(super) struct Findings {
    /// The missing parts of the code.
    pub missing: Vec<String>,
    /// Messages about errors.
    pub wrong: Vec<String>,
    /// The comparisons.
    pub check: Check,
}

impl Findings {
    /// Runs the examples of a code, and its check. The empty `check` says whether somebody looks
    /// at pictures.
    pub fn of(code: Code, mut check: Check) -> Self {
        found_missing().clear();
        let mut wrong = Vec::new();
        let fails = |run: &mut dyn FnMut()| catch_unwind(AssertUnwindSafe(run)).is_err();
        if fails(&mut || (code.examples)()) {
            let fails = "an example at the end of the file fails, with the message above";
            wrong.push(fails.to_owned());
        }
        if fails(&mut || (code.check)(&mut check)) {
            wrong.push("it panics, with the message above".to_owned());
        }
        wrong.extend(check.first.take());
        if check.differ > 0 {
            let (differ, compared) = (check.differ, check.compared);
            wrong.push(format!("{differ} of {compared} comparisons differ"));
        } else if check.compared <= check.skipped {
            wrong.push("nothing is compared".to_owned());
        }
        Self {
            missing: mem::take(&mut found_missing()),
            wrong,
            check,
        }
    }
}
