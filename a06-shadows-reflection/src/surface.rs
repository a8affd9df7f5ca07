//! `Surface`: a material with a mirror reflectance.

use a05_lighting::{Lambert, Material, Phong, SingleColor};
use common::Color;

/// A material that may mirror.
pub trait Surface: Material {
    /// The mirror reflectance in each channel.
    fn mirror_reflectance(&self) -> Color {
        Color::BLACK
    }
}

impl Surface for SingleColor {}
impl Surface for Lambert {}
impl Surface for Phong {}
