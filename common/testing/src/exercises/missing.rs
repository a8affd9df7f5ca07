//! `missing`: parts of a starter that are left to the student.

use std::cell::RefCell;
use std::panic::Location;

/// A part that is left to the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// Its code in words.
    pub what: String,
    /// The line of the file in which it is missing.
    pub line: u32,
}

thread_local! {
    /// The parts that code on this thread has found missing. Questions are asked on one thread.
    static MISSING: RefCell<Vec<Missing>> = RefCell::default();
}

/// The parts that were found missing since the last call.
pub(crate) fn take_missing() -> Vec<Missing> {
    MISSING.take()
}

/// A placeholder in a starter for the student's code; returns `for_now`. The program
/// that calls it reports once that `what` is missing, and in which line.
#[track_caller]
pub fn missing<T>(what: &str, for_now: T) -> T {
    let line = Location::caller().line();
    MISSING.with_borrow_mut(|missing| {
        if !missing.iter().any(|known| known.what == what) {
            let what = what.to_owned();
            missing.push(Missing { what, line });
        }
    });
    for_now
}
