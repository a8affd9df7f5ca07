//! Tests of the vectors and matrices of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod acceptance;
mod laws;
mod scenes;
