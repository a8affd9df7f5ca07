//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod double_double;
mod exact;
mod experiments;
mod extremes;
mod needle;
mod protocol;
mod real;
mod sphere_distance;
