//! `missing`: parts of a starter that are left to the student.

use std::panic::Location;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A part that is left to the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// Its code in words.
    pub what: String,
    /// The line of the file in which it is missing.
    pub line: u32,
}

/// The parts that the running code has found missing.
pub(crate) fn found_missing() -> MutexGuard<'static, Vec<Missing>> {
    static MISSING: Mutex<Vec<Missing>> = Mutex::new(Vec::new());
    MISSING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A placeholder in a starter for the student's code; returns `for_now`. The program
/// that calls it reports once that `what` is missing, and in which line.
#[track_caller]
pub fn missing<T>(what: &str, for_now: T) -> T {
    let mut missing = found_missing();
    if !missing.iter().any(|known| known.what == what) {
        missing.push(Missing {
            what: what.to_owned(),
            line: Location::caller().line(),
        });
    }
    for_now
}
