//! Assignment 3: rays, cameras, and a striped sky.
//!
//! A [`Camera`] turns a position in the picture into a [`Ray`]; [`render`] takes
//! the rays of every pixel from it, and the radiance of each ray from a function.

mod bounded_ray;
mod camera;
#[doc(hidden)]
pub mod instruments;
pub mod kinds;
mod orthographic_camera;
mod perspective_camera;
mod pinhole_camera;
mod random;
mod ray;
mod render;
mod sampler;
#[doc(hidden)]
pub mod scenes;
mod stage;
mod striped_sky;
mod view;

pub use bounded_ray::BoundedRay;
pub use camera::{Basis, Camera};
#[doc(hidden)]
pub use instruments::pixel_trace::paint;
pub use orthographic_camera::OrthographicCamera;
pub use perspective_camera::PerspectiveCamera;
pub use pinhole_camera::PinholeCamera;
pub use random::PixelRandom;
pub use ray::Ray;
pub use render::{camera_coordinates, render};
pub use sampler::Sampler;
pub use stage::{scenes as traced_scenes, stage};
pub use striped_sky::{StripeRule, StripedSky};
pub use view::{TracedScene, TracedWorld, View, ViewOfSettings};
