//! `assert_refused`: checks the error of a constructor.

use std::fmt::Debug;

use common::ArgumentError;

/// Checks that arguments are refused, by a message that begins with the argument's `name`
/// and gives the `allowed` values.
///
/// # Panics
///
/// If they are accepted, or by another message.
#[track_caller]
pub fn assert_refused<T: Debug>(result: Result<T, ArgumentError>, name: &str, allowed: &str) {
    let message = result.expect_err(name).to_string();
    assert!(
        message.starts_with(name) && message.contains(allowed),
        "{message}"
    );
}
