//! Test tools of the stages: [`lock_pictures!`] compares the pictures of a stage
//! with locked ones, [`exercises!`] judges students' files, [`Random`] gives random
//! inputs, [`assert_refused`] checks the error of a constructor, and `display` is for tests of the window.
//!
//! Only tests depend on this crate, so that no program contains test code. Its checks
//! fail by a panic.

#![allow(clippy::missing_panics_doc, reason = "every check of a test panics")]
#![allow(
    clippy::crate_in_macro_def,
    reason = "the students' files are in the crate that calls"
)]
#![cfg_attr(target_family = "wasm", allow(dead_code, reason = "nothing is judged"))]

#[cfg(target_os = "linux")]
pub mod display;
pub mod exercises;
#[cfg(not(target_family = "wasm"))]
pub mod picture_lock;
mod random;
mod refusal;

pub use exercises::{assert_close, missing};
pub use random::{Random, for_seeds};
pub use refusal::assert_refused;

/// The files of the lesson and of the engine with the same formula, for the message that their pictures differ.
pub const FORMULAS: &str = include_str!("formulas.txt");
