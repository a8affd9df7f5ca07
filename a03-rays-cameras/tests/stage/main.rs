//! Tests of the rays, cameras and samples of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod cameras;
mod rays;
mod sampling;
#[cfg(all(target_os = "linux", feature = "window"))]
mod window;
mod work;
