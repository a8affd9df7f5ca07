//! The laboratory: measures the lesson of this stage, and is no part of it.

#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod aimed_box;
pub mod certified;
pub mod enclosure;
pub mod exact;
pub mod experiments;
pub mod extremes;
pub mod mesh;
pub mod protocol;
pub mod search;
pub mod subject;
pub mod support;
pub mod watched;
