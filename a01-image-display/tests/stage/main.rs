//! Tests of the pictures and the program of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod command_line;
mod show_image;
