//! The laboratory: measures the lesson of this stage, and is no part of it.

#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

mod drawing;
pub mod experiments;
pub mod extremes;
pub mod pixel_trace;
pub mod protocol;
mod seen_rays;
pub mod turned;
pub mod watched;

pub(crate) use pixel_trace::ViewOf;
