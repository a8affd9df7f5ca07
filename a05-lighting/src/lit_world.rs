//! `LitWorld`: a world and the lights in it.

use std::ops::Deref;
use std::sync::Arc;

use a03_rays_cameras::{Focus, Ray};
use a04_intersections::{Geometry, Hit, Interval, World};
use common::{ArgumentError, Color, Plan, argument};

use crate::{Illumination, Light, Lighting, Material};

/// A world of surfaces `S`, its lights `L` and the ambient light.
#[derive(Debug)]
pub struct LitWorld<S = Box<dyn Material>, L = Box<dyn Light>> {
    world: World<S>,
    lights: Vec<L>,
    ambient: Color,
    omit: bool,
}

impl LitWorld {
    /// A world without objects and lights.
    pub fn new(background: Color, ambient: Color) -> Result<Self, ArgumentError> {
        Self::empty(background, ambient)
    }
}

impl<S, L> LitWorld<S, L> {
    /// A world without objects and lights, of whatever surfaces and lights.
    pub fn empty(background: Color, ambient: Color) -> Result<Self, ArgumentError> {
        Ok(Self {
            world: World::new(background)?,
            lights: Vec::new(),
            ambient: argument::color("ambient light", ambient)?,
            omit: true,
        })
    }

    /// This world and one more object.
    #[must_use]
    pub fn with(mut self, geometry: impl Geometry + 'static, surface: S) -> Self {
        self.world = self.world.with(geometry, surface);
        self
    }

    /// This world and one more light.
    #[must_use]
    pub fn lit_by(mut self, light: L) -> Self {
        self.lights.push(light);
        self
    }

    /// The same world, with other geometries [in place](World::replacing) of some.
    #[must_use]
    pub fn replacing(mut self, other: impl Fn(&dyn Geometry) -> Option<Arc<dyn Geometry>>) -> Self {
        self.world = self.world.replacing(other);
        self
    }

    /// The same world, its objects [prepared](World::prepared) for many rays.
    #[must_use]
    pub fn prepared(mut self, foci: impl IntoIterator<Item = Focus>) -> Self {
        self.world = self.world.prepared(foci);
        self
    }

    /// The same world, prepared if work that changes no colour is to be left
    /// out, else doing all of it.
    #[must_use]
    pub fn omitting(mut self, omit: bool, foci: impl IntoIterator<Item = Focus>) -> Self {
        self.omit = omit;
        if omit { self.prepared(foci) } else { self }
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

    /// The light that comes from everywhere.
    #[must_use]
    pub const fn ambient(&self) -> Color {
        self.ambient
    }
}

impl<S: Deref<Target: Material>, L> LitWorld<S, L> {
    /// Adds to a plan what there is to be met and to be lit.
    #[must_use]
    pub fn plan(&self, plan: Plan) -> Plan {
        let (objects, lights) = (self.world.len(), self.lights.len());
        let plan = self.world.plan(plan).needing(format!("lights: {lights}"));
        if lights == 0 {
            return plan.without("all shading by lights", "there is none");
        }
        let count = |what: fn(&S::Target) -> bool| {
            let surfaces = self.world.objects().map(|(_, surface)| surface);
            surfaces.filter(|surface| !what(surface)).count()
        };
        let plan = match count(S::Target::answers_light) {
            0 => plan,
            dull => plan.without(
                format!("light on {dull} of {objects} objects"),
                "their colour does not depend on it",
            ),
        };
        let dull = count(S::Target::has_highlight);
        let mut plan = plan;
        if dull > 0 {
            plan = plan.without(
                format!("powers on {dull} of {objects} objects"),
                "they have no highlight",
            );
        }
        if dull < objects {
            plan = plan.without(
                "powers where a light is behind, or mirrored away from the eye",
                "no highlight is seen there",
            );
        }
        plan
    }
}

impl LitWorld {
    /// The colour that a ray brings back: what the material of the nearest
    /// object makes of the light, or the background.
    #[must_use]
    pub fn color_for(&self, ray: &Ray) -> Color {
        let nearest = self.world.hit(ray, Interval::AHEAD);
        nearest.map_or(self.world.background(), |(hit, material)| {
            material.color_for(ray, &hit, self)
        })
    }
}

/// All light arrives: nothing casts a shadow.
impl Lighting for LitWorld {
    fn ambient(&self) -> Color {
        self.ambient
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        let lights = self.lights.iter();
        lights
            .filter_map(|light| light.illumination(point))
            .for_each(|light| shade(&light));
    }

    fn omits(&self) -> bool {
        self.omit
    }
}
