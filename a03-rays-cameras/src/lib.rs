//! Assignment 3: rays, cameras, and a striped sky.
//!
//! A [`Camera`] turns a position in the picture into a [`Ray`]; [`render`] takes
//! the rays of every pixel from it, and the radiance of each ray from a function.

mod adapter;
mod bounded_ray;
mod camera;
mod orthographic_camera;
mod perspective_camera;
mod pinhole_camera;
mod random;
mod ray;
mod render;
mod sampler;
#[doc(hidden)]
pub mod scenes;
mod striped_sky;
mod view;

pub use crate::adapter::registry;
pub use crate::adapter::stage;
pub use crate::adapter::traced_world::TracedWorld;
pub use crate::adapter::views::{Views, traced_scene};
#[doc(hidden)]
pub use crate::adapter::{instruments, instruments::pixel_trace::paint};
pub use bounded_ray::BoundedRay;
pub use camera::{Basis, Camera};
pub use orthographic_camera::OrthographicCamera;
pub use perspective_camera::PerspectiveCamera;
pub use pinhole_camera::PinholeCamera;
pub use random::PixelRandom;
pub use ray::Ray;
pub use render::{camera_coordinates, render};
pub use sampler::Sampler;
pub use striped_sky::{StripeRule, StripedSky};
pub use view::View;
