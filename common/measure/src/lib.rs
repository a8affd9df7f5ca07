//! Measures the code of a stage: error against work in experiments, extreme
//! cases against exact values, and the work of a rendering, counted.
//!
//! This crate prints nothing and does not depend on a terminal. A [`Stage`] holds
//! the scenes of a stage with its experiments and extreme cases, for the program
//! and for the tests.

#![expect(
    clippy::must_use_candidate,
    clippy::return_self_not_must_use,
    reason = "called by the laboratories, the program and the tests"
)]

pub mod comparison;
mod curve;
mod deviation;
mod effort;
#[cfg(test)]
mod example;
pub mod experiment;
pub mod extremes;
pub mod fit;
mod front;
mod plot;
mod provenance;
pub mod report;
pub mod scene_report;
mod stage;
pub mod timing;

pub use effort::Effort;
pub use plot::{Svg, color as svg_color};
pub use stage::Stage;
