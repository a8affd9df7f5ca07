//! The laboratory: measures the lesson of this stage, and is no part of it.

#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod experiments;
pub mod extremes;
mod light_places;
pub mod protocol;
pub mod watched;

pub use light_places::light_places;
