//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod errata_rows;

testing::check_lab! { a07_transforms::stage() }
