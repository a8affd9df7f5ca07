//! `Scene`: shapes, surfaces and lights as plain numbers.

use common::Color;

use crate::accel::Shapes;
use crate::{Light, Shape, Surface};

/// A scene.
#[derive(Debug)]
pub struct Scene<'a> {
    pub(crate) background: Color,
    pub(crate) ambient: Color,
    pub(crate) depth: u32,
    pub(crate) shapes: Shapes<'a>,
    pub(crate) surfaces: Vec<Surface<'a>>,
    pub(crate) lights: Vec<Light<'a>>,
}

impl<'a> Scene<'a> {
    /// An empty scene: the colour of rays without a hit, the ambient light, and the largest number
    /// of surfaces that a path meets.
    #[must_use]
    pub fn new(background: Color, ambient: Color, depth: u32) -> Self {
        Self {
            background,
            ambient,
            depth,
            shapes: Shapes::default(),
            surfaces: Vec::new(),
            lights: Vec::new(),
        }
    }

    /// Adds a surface, and returns its index.
    pub fn add_surface(&mut self, surface: Surface<'a>) -> u32 {
        self.surfaces.push(surface);
        self.surfaces.len() as u32 - 1
    }

    /// Adds a shape with the surface of this index. Of several shapes hit at the same
    /// `t`, the first added counts.
    pub fn add_shape(&mut self, shape: Shape<'a>, surface: u32) {
        self.shapes.push(shape, surface);
    }

    /// Adds a light.
    pub fn add_light(&mut self, light: Light<'a>) {
        self.lights.push(light);
    }
}
