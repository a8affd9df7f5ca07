//! Counts powers, by a wrapper around each material.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, counted};
use common::tally::{self, Work};
use common::{ArgumentError, Color};

use crate::lab::decorated::decorated;
use crate::lab::highlight::{as_phong, takes_power};
use crate::lab::watched::Watched;
use crate::{Lighting, LitWorld, Material, Phong};

/// Wraps the objects of a world to count intersection tests and powers.
pub fn world(world: LitWorld) -> Result<LitWorld, ArgumentError> {
    decorated(world, counted::geometry, |material| {
        Box::new(Counted(material)) as _
    })
}

#[derive(Debug)]
struct Counted(Box<dyn Material>);

impl Material for Counted {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        counted_powers(as_phong(&*self.0), lighting, |lighting| {
            self.0.color_for(ray, hit, lighting)
        })
    }
}

/// The colour of a material in this light, with its powers counted. `phong` is the
/// material as a Phong material, if it is one.
pub fn counted_powers(
    phong: Option<&Phong>,
    lighting: &dyn Lighting,
    color_for: impl FnOnce(&dyn Lighting) -> Color,
) -> Color {
    color_for(&Watched::new(lighting, |ray, hit, light| {
        if phong.is_some_and(|phong| takes_power(phong, ray, hit, light)) {
            tally::count(Work::Power);
        }
        true
    }))
}
