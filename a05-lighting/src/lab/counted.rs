//! Counts powers, by a wrapper around each material.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, counted};
use common::tally::{self, Work};
use common::{ArgumentError, Color};

use crate::lab::decorated::decorated;
use crate::lab::highlight::{as_phong, is_mirrored};
use crate::{Illumination, Lighting, LitWorld, Material};

/// The same world, counting intersection tests and powers.
pub fn world(world: LitWorld) -> Result<LitWorld, ArgumentError> {
    decorated(world, counted::geometry, |material| {
        Box::new(Counted(material)) as _
    })
}

#[derive(Debug)]
struct Counted(Box<dyn Material>);

impl Material for Counted {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        if as_phong(&*self.0).is_some() {
            self.0.color_for(ray, hit, &CountedLights(lighting))
        } else {
            self.0.color_for(ray, hit, lighting)
        }
    }
}

/// The light for a Phong material, which counts the powers that it takes.
pub struct CountedLights<'a>(pub &'a dyn Lighting);

impl Lighting for CountedLights<'_> {
    fn ambient(&self) -> Color {
        self.0.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.0.for_each_light(ray, hit, &mut |light| {
            if is_mirrored(ray, hit, light) {
                tally::count(Work::Power);
            }
            shade(light);
        });
    }
}
