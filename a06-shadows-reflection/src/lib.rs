//! Assignment 6: shadows, and surfaces that mirror.
//!
//! The [`RecursiveTracer`] answers what light reaches a hit with shadow rays,
//! and follows reflected rays from surface to surface.

mod cut;
mod foci;
mod lab;
mod light_source;
mod recursive_tracer;
mod reflective;
mod scenes;
mod secondary_ray;
mod shadow;
mod surface;
mod trace_together;
mod traced_scene;

pub use foci::foci;
#[doc(hidden)]
pub use lab::protocol;
pub use light_source::LightSource;
pub use recursive_tracer::{RecursiveTracer, ShadowedWorld};
pub use reflective::Reflective;
pub use scenes::stage;
pub use secondary_ray::secondary_ray;
pub use shadow::is_shadowed;
pub use surface::Surface;
pub use trace_together::TracedLight;
pub use traced_scene::{traced_scene, tracer};

/// The code in this stage's chapter is tested with it.
#[cfg(doctest)]
#[doc = include_str!("../../book/src/a06-shadows-reflection.md")]
mod book {}
