//! Measures the code of a stage: error against work in experiments, and extreme cases
//! against exact values.
//!
//! A [`Laboratory`] holds the experiments and extreme cases of a stage, for its program and for
//! the tests.

#![expect(
    clippy::must_use_candidate,
    clippy::return_self_not_must_use,
    reason = "called by the laboratories, the program and the tests"
)]

#[cfg(not(target_family = "wasm"))]
mod command_line;
mod curve;
mod effort;
pub mod exact;
#[cfg(test)]
mod example;
pub mod experiment;
pub mod extremes;
pub mod fit;
pub mod front;
mod interval;
mod laboratory;
pub mod plot;
mod point;
pub mod provenance;
pub mod recorded;
pub mod report;
mod rounded_interval;
mod rounds;
pub mod scene_report;
pub mod sweep;
mod t_distribution;
pub mod time_to_error;

#[cfg(not(target_family = "wasm"))]
pub use command_line::{run, run_with};
pub use effort::Effort;
pub use laboratory::Laboratory;
pub use rounded_interval::RoundedInterval;
pub use rounds::{Rounds, Turn};
