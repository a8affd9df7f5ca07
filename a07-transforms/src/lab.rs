//! The laboratory: measures the lesson of this stage, and is no part of it.

#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod certified;
pub mod experiments;
pub mod extremes;
pub mod protocol;
pub mod search;
pub(crate) mod watched;
