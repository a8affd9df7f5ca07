//! `LitWorld`: a world and the lights in it.

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, World};
use common::{ArgumentError, Color, argument};

use crate::{Illumination, Light, Lighting, Material};

/// A world of surfaces `S`, its lights `L` and the ambient light.
#[derive(Debug)]
pub struct LitWorld<S = Box<dyn Material>, L = Box<dyn Light>> {
    pub(crate) world: World<S>,
    pub(crate) lights: Vec<L>,
    pub(crate) ambient: Color,
}

impl LitWorld {
    /// A world without objects and lights.
    pub fn new(background: Color, ambient: Color) -> Result<Self, ArgumentError> {
        Self::empty(background, ambient)
    }
}

impl<S, L> LitWorld<S, L> {
    /// A world without objects and lights, of any type of surfaces and lights.
    pub fn empty(background: Color, ambient: Color) -> Result<Self, ArgumentError> {
        Ok(Self {
            world: World::new(background)?,
            lights: Vec::new(),
            ambient: argument::color("ambient light", ambient)?,
        })
    }

    /// This world with one more object.
    #[must_use]
    pub fn with(mut self, geometry: impl Geometry, surface: S) -> Self {
        self.world = self.world.with(geometry, surface);
        self
    }

    /// This world with one more light.
    #[must_use]
    pub fn lit_by(mut self, light: L) -> Self {
        self.lights.push(light);
        self
    }

    /// The objects.
    #[must_use]
    pub const fn objects(&self) -> &World<S> {
        &self.world
    }

    /// The lights.
    #[must_use]
    pub fn lights(&self) -> &[L] {
        &self.lights
    }

    /// The ambient light.
    #[must_use]
    pub const fn ambient(&self) -> Color {
        self.ambient
    }
}

impl LitWorld {
    /// The colour that a ray brings back: the light reflected by the material of
    /// the nearest object, or the background.
    #[must_use]
    pub fn color_for(&self, ray: &Ray) -> Color {
        let nearest = self.world.hit(ray, Interval::AHEAD);
        nearest.map_or(self.world.background(), |(hit, material)| {
            material.color_for(ray, &hit, self)
        })
    }
}

/// All light arrives: no object casts a shadow.
impl Lighting for LitWorld {
    fn ambient(&self) -> Color {
        self.ambient
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        let lights = self.lights.iter();
        for light in lights.filter_map(|light| light.illumination(point)) {
            shade(&light);
        }
    }
}
