//! Lighting that leaves nothing out, for the comparison with the lesson: every
//! material computes the light of all lights, and every light on a Phong material
//! a power.

use std::hint::black_box;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::tally::{self, Work};
use common::{ArgumentError, Color};

use crate::lab::decorated::decorated;
use crate::lab::highlight::{as_phong, takes_power};
use crate::lab::watched::Watched;
use crate::power::power;
use crate::{Illumination, Lighting, LitWorld, Material, Phong};

/// Wraps the materials of a world to do all work. The colours do not change.
pub fn world(world: LitWorld) -> Result<LitWorld, ArgumentError> {
    decorated(
        world,
        |geometry| geometry,
        |material| Box::new(AllWork(material)) as _,
    )
}

#[derive(Debug)]
struct AllWork(Box<dyn Material>);

impl Material for AllWork {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        shade(as_phong(&*self.0), ray, hit, lighting, |lighting| {
            self.0.color_for(ray, hit, lighting)
        })
    }
}

/// The colour of a material in this light, computed with all work.
/// `phong` is the material as a Phong material, if it is one.
pub fn shade(
    phong: Option<&Phong>,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
    color_for: impl FnOnce(&dyn Lighting) -> Color,
) -> Color {
    let watch = |ray: &Ray, hit: &Hit, light: &Illumination| {
        if let Some(phong) = phong {
            tally::count(Work::Power);
            if !takes_power(phong, ray, hit, light) {
                // An unused number, which the compiler would remove.
                black_box(power(black_box(0.5), phong.exponent));
            }
        }
        true
    };
    let all = Watched::new(lighting, watch);
    let color = color_for(&all);
    if !all.is_used() {
        all.for_each_light(ray, hit, &mut |_| ());
    }
    color
}
