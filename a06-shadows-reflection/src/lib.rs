//! Assignment 6: shadows, and surfaces that mirror.
//!
//! The [`RecursiveTracer`] finds the light that reaches a hit with shadow rays,
//! and follows reflected rays from surface to surface.

#[doc(hidden)]
pub mod instruments;
pub mod kinds;
mod light_source;
mod mirror_direction;
mod recursive_tracer;
mod reflective;
#[doc(hidden)]
pub mod scenes;
mod secondary_ray;
mod shadow;
mod stage;
mod surface;

pub use light_source::LightSource;
pub use mirror_direction::mirror_direction;
pub use recursive_tracer::{RecursiveTracer, ShadowedWorld};
pub use reflective::Reflective;
pub use scenes::diagonal_camera;
pub use secondary_ray::secondary_ray;
pub use shadow::is_shadowed;
pub use stage::{RecursiveWorld, scenes as traced_scenes, stage, traced, traced_with};
pub use surface::Surface;
