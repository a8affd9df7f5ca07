//! Assignment 6: shadows, and surfaces that mirror.
//!
//! The [`RecursiveTracer`] finds the light that reaches a hit with shadow rays,
//! and follows reflected rays from surface to surface.

mod adapter;
mod light_source;
mod mirror_direction;
mod recursive_tracer;
mod reflective;
#[doc(hidden)]
pub mod scenes;
mod secondary_ray;
mod shadow;
mod surface;

#[doc(hidden)]
pub use crate::adapter::instruments;
pub use crate::adapter::registry;
pub use crate::adapter::{RecursiveWorld, stage, traced, traced_with};
pub use light_source::LightSource;
pub use mirror_direction::mirror_direction;
pub use recursive_tracer::{RecursiveTracer, ShadowedWorld};
pub use reflective::Reflective;
pub use scenes::diagonal_camera;
pub use secondary_ray::{rounding_error, secondary_ray};
pub use shadow::is_shadowed;
pub use surface::Surface;
