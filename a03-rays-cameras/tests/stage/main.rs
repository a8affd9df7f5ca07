//! Tests of the rays, cameras, samples, stripes and black pictures of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod black_picture;
mod cameras;
mod orbit_camera;
mod rays;
mod sampling;
mod stripes;
