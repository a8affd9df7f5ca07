//! Judges what a student's program answers and draws against what is right.
//!
//! [`answers`] are given to the questions of an exercise, [`pictures`] drawn for an open sheet. This crate starts no
//! program: `cargo learn` and the grader of a course do so, each within its own limits.

pub mod answers;
pub mod pictures;

/// Beside the macro of this name: the function of earlier starters.
pub use answers::assert_close;
