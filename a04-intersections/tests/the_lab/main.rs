//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod exact;

testing::check_lab! { a04_intersections::stage() }
