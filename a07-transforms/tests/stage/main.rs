//! Tests of the transforms, nodes and discs of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod adaptive;
mod dahlia;
mod disc;
mod engine;
mod mat4x4;
mod node;
#[path = "../../../a04-intersections/tests/stage/support.rs"]
mod support;
mod transform;
