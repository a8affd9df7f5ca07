//! Tests of the transforms, nodes and discs of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod adaptive;
mod black_pictures;
mod dahlia;
mod deep_reflections;
mod disc;
mod engine;
mod explained;
mod export;
mod extreme_scenes;
mod lamps_on_groups;
mod levels;
mod negative_zeros;
mod node;
mod own_shape;
mod rows;
mod scales;
mod scene_files;
mod sensitivity;
mod transform;
