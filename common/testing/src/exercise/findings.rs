//! `Findings`: the missing parts of a student's code, and its errors.

use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};

pub(super) use crate::exercises::found_missing;

use super::{Answer, Check, Code};

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
