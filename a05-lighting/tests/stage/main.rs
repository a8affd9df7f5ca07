//! Tests of the lights and materials of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod lights;
mod materials;
mod refusals;
