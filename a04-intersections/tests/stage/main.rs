//! Tests of the shapes and the world of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod axis_aligned_box;
mod contact;
mod engine;
mod every_shape;
mod extreme_scenes;
mod mesh;
mod sphere;
mod triangle;
mod world;
