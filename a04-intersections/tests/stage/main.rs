//! Tests of the shapes and the world of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod axis_aligned_box;
mod contact;
mod every_shape;
mod mesh;
mod sphere;
mod test_shapes;
mod triangle;
mod world;
