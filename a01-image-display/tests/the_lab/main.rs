//! Tests of `src/lab`: experiments of this stage.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod experiments;
