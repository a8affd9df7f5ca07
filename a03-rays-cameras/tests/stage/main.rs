//! Tests of the rays, cameras, samples and stripes of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod cameras;
mod orbit_camera;
mod rays;
mod sampling;
mod stripes;
