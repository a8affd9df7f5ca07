//! Tests of the program of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod command_line;
