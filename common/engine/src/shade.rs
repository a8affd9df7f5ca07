//! Lights, surfaces, and the light that surfaces send back.

mod light;
mod phong;
mod power;
mod radiance_bound;
mod surface;

pub(crate) use light::IlluminationPacket;
pub use light::{Emitter, Illumination, Light, LightFn};
pub use phong::Phong;
pub(crate) use phong::PhongPacket;
pub(crate) use radiance_bound::{RadianceBound, max_radiance};
pub use surface::{ShadeFn, Shading, Surface};
