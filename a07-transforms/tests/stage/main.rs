//! Tests of the nodes of this stage, and of the engine against the lesson. Matrices,
//! transforms and discs are held by the extreme cases G01 to G32 and B12 to B31 and by the
//! exercises.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod adaptive;
#[path = "../../../a04-intersections/tests/stage/engine/compare.rs"]
mod compare;
mod dahlia;
mod engine;
mod node;
mod refusals;
#[path = "../../../a04-intersections/tests/stage/support.rs"]
#[expect(dead_code, reason = "stage 4 uses more of it")]
mod support;
