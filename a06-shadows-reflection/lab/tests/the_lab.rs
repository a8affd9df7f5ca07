//! experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

testing::check_lab! { a06_lab::laboratory() }
