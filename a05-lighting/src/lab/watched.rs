//! `Watched`: light on its way to a material, seen by a function that counts it or stops it.

use std::cell::Cell;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::{Illumination, Lighting};

/// A wrapper of the lighting that calls a function for each light, and passes the light
/// on to the material if the result is true.
pub struct Watched<'a, W> {
    lighting: &'a dyn Lighting,
    watch: W,
    is_used: Cell<bool>,
}

impl<'a, W: Fn(&Ray, &Hit, &Illumination) -> bool> Watched<'a, W> {
    pub const fn new(lighting: &'a dyn Lighting, watch: W) -> Self {
        Self {
            lighting,
            watch,
            is_used: Cell::new(false),
        }
    }

    /// Whether a material has used the lights.
    pub const fn is_used(&self) -> bool {
        self.is_used.get()
    }
}

impl<W: Fn(&Ray, &Hit, &Illumination) -> bool> Lighting for Watched<'_, W> {
    fn ambient(&self) -> Color {
        self.lighting.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.is_used.set(true);
        self.lighting.for_each_light(ray, hit, &mut |light| {
            if (self.watch)(ray, hit, light) {
                shade(light);
            }
        });
    }
}
