//! `Surface`: a material, and how much of its surroundings it mirrors.

use a05_lighting::{Lambert, Material, Phong, SingleColor};
use common::Color;

/// A material that may mirror.
pub trait Surface: Material {
    /// The share of each channel that is mirrored.
    fn reflection(&self) -> Color {
        Color::BLACK
    }
}

impl Surface for SingleColor {}
impl Surface for Lambert {}
impl Surface for Phong {}
