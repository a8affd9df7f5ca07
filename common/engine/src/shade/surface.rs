//! `Surface`: the material of an object and its reflectance.

use common::Color;

use super::Phong;
use crate::{Hit, Ray};

/// A surface.
pub struct Surface<'a> {
    /// The material: the light that it scatters.
    pub shading: Shading<'a>,
    /// The reflectance of each channel, from 0 to 1.
    pub reflection: Color,
}

/// The light that goes from a hit back along its ray.
pub type ShadeFn<'a> = Box<dyn Fn(&Ray, &Hit) -> Color + Send + Sync + 'a>;

/// The kinds of materials.
pub enum Shading<'a> {
    /// Looks the same in any light.
    SingleColor(Color),
    /// Scatters light, and mirrors lights as highlights.
    Phong(Phong),
    /// A material that the engine does not know: each hit is shaded by this function.
    Other(ShadeFn<'a>),
}

impl<'a> Surface<'a> {
    /// A surface that mirrors nothing.
    #[must_use]
    pub const fn matt(shading: Shading<'a>) -> Self {
        Self {
            shading,
            reflection: Color::BLACK,
        }
    }

    /// Upper bound of its colour, per channel, with this ambient light and this sum of
    /// the light of all sources.
    pub(crate) fn max_radiance(&self, ambient: Color, lights: Color) -> Color {
        match &self.shading {
            Shading::SingleColor(color) => *color,
            Shading::Phong(phong) => phong.max_radiance(ambient, lights),
            Shading::Other(_) => Color::gray(f64::INFINITY),
        }
    }
}
