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

#[cfg(not(handout))]
pub mod comparison;
#[cfg(not(handout))]
mod curve;
#[cfg(not(handout))]
mod deviation;
#[cfg(not(handout))]
mod effort;
#[cfg(test)]
mod example;
#[cfg(not(handout))]
pub mod experiment;
#[cfg(not(handout))]
pub mod extremes;
#[cfg(not(handout))]
pub mod fit;
#[cfg(not(handout))]
mod front;
#[cfg(not(handout))]
mod plot;
#[cfg(not(handout))]
mod provenance;
#[cfg(not(handout))]
pub mod report;
#[cfg(not(handout))]
pub mod scene_report;
mod stage;
#[cfg(not(handout))]
pub mod timing;

#[cfg(not(handout))]
pub use effort::Effort;
#[cfg(not(handout))]
pub use plot::{Svg, color as svg_color};
pub use stage::Stage;
