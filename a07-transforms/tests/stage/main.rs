//! Tests of the transforms, nodes and discs of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod adaptive;
#[path = "../../../a04-intersections/tests/stage/engine/compare.rs"]
mod compare;
mod dahlia;
mod deep_reflections;
mod disc;
mod engine;
mod explained;
mod export;
mod extreme_scenes;
mod lamps_on_groups;
mod negative_zeros;
mod node;
mod own_shape;
mod rows;
mod scene_files;
#[path = "../../../a04-intersections/tests/stage/support.rs"]
#[expect(dead_code, reason = "stage 4 uses more of it")]
mod support;
mod transform;
