//! The fast renderer: it draws the pictures of the lessons, byte for byte, in less time.
//!
//! It works on plain numbers and depends on no stage: a stage passes a [`Scene`] and a
//! [`Camera`], and a function for each object that the engine does not know. It repeats
//! the formulas of the lessons in the same order of operations, for four rays side by side,
//! and skips tests only of shapes that a ray cannot hit. The README beside this crate has a map.

#![expect(
    clippy::inline_always,
    reason = "a function on lanes has to become a part of its caller: see `lanes`"
)]

mod accel;
pub mod adaptive;
mod camera;
mod lanes;
mod ray;
mod renderer;
mod sampler;
mod scene;
mod shade;
mod shape;
mod trace;
mod vector;
mod view;

pub use camera::{Basis, Camera, RayFn};
pub use lanes::level::{HAS_ONE as HAS_ONE_LEVEL, at_each_level};
pub use ray::{Hit, Ray};
pub use renderer::Renderer;
pub use sampler::Sampler;
pub use scene::Scene;
pub use shade::{Emitter, Illumination, Light, LightFn, Phong, ShadeFn, Shading, Surface};
pub use shape::{
    AnyHitFn, AxisAlignedBox, Disc, HitFn, Instance, Plane, Shape, Sphere, Transform, Triangle,
};
