//! Assignment 3: rays, the cameras that send them, and the sky they meet.
//!
//! A [`Camera`] turns a place in the picture into a [`Ray`]; [`render`] asks it
//! for the rays of every pixel, and someone else for the light along each.

mod adaptive;
mod bounded_ray;
mod camera;
mod focus;
mod lab;
mod orthographic_camera;
mod perspective_camera;
mod pinhole_camera;
mod radiance;
mod random;
mod ray;
mod ray_packet;
mod render;
mod sampler;
mod scenes;
mod striped_sky;

pub use bounded_ray::BoundedRay;
pub use camera::{Basis, Camera};
pub use focus::Focus;
#[doc(hidden)]
pub use lab::protocol;
pub use orthographic_camera::OrthographicCamera;
pub use perspective_camera::PerspectiveCamera;
pub use pinhole_camera::PinholeCamera;
pub use radiance::Radiance;
pub use random::PixelRandom;
pub use ray::Ray;
pub use ray_packet::RayPacket;
pub use render::{render, render_rows, render_together};
pub use sampler::Sampler;
pub use scenes::stage;
pub use striped_sky::{StripeRule, StripedSky};

/// The code in this stage's chapter is tested with it.
#[cfg(doctest)]
#[doc = include_str!("../../book/src/a03-rays-cameras.md")]
mod book {}
