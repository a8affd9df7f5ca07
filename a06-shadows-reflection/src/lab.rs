//! The laboratory: measures the lesson of this stage, and is no part of it.

#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub(crate) mod all_work;
pub mod experiments;
pub mod extremes;
pub mod lit_points;
pub mod protocol;
pub mod watched;
