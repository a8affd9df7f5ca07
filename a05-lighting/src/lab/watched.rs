//! Counts powers, by a wrapper around each material; with all work, every material computes
//! the light of all lights, and a Phong material a power for each.

use std::cell::Cell;
use std::hint::black_box;

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, watched};
use common::Color;
use common::tally::{self, Work};

use crate::power::power;
use crate::{Illumination, Lighting, LitWorld, Material, Phong};

/// The world with the same lights, and with its geometries and surfaces replaced by these
/// functions of them.
pub fn world<S, T, L>(
    world: LitWorld<S, L>,
    geometry: impl Fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
) -> LitWorld<T, L> {
    LitWorld {
        world: watched::world(world.world, geometry, surface),
        lights: world.lights,
        ambient: world.ambient,
    }
}

/// A material whose powers are counted.
#[derive(Debug)]
pub struct Watched {
    /// The material.
    pub material: Box<dyn Material>,
    /// Whether it does the work that the lesson leaves out.
    pub all_work: bool,
}

impl Material for Watched {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let any: &dyn std::any::Any = &*self.material;
        let phong = any.downcast_ref();
        shade(phong, self.all_work, ray, hit, lighting, |lighting| {
            self.material.color_for(ray, hit, lighting)
        })
    }
}

/// The colour of a material in this light, with its powers counted, and all work done if that
/// is wanted. `phong` is the material as a Phong material, if it is one.
pub fn shade(
    phong: Option<&Phong>,
    all_work: bool,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
    color_for: impl FnOnce(&dyn Lighting) -> Color,
) -> Color {
    let watched = WatchedLight::new(lighting, |ray, hit, light| {
        if let Some(phong) = phong {
            let is_needed = takes_power(phong, ray, hit, light);
            if is_needed || all_work {
                tally::count(Work::Power);
            }
            if all_work && !is_needed {
                // The compiler would remove a number that is not used.
                black_box(power(black_box(0.5), phong.exponent));
            }
        }
        true
    });
    let color = color_for(&watched);
    if all_work && !watched.is_used.get() {
        watched.for_each_light(ray, hit, &mut |_| ());
    }
    color
}

/// Whether a Phong material computes a power for this light: Phong's condition.
fn takes_power(phong: &Phong, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let (e, l) = (-ray.direction(), light.direction);
    let is_mirrored = hit.normal.dot(l) > 0.0 && e.dot(l.reflected_on(hit.normal)) > 0.0;
    is_mirrored && phong.specular != Color::BLACK
}

/// Light on its way to a material. A function sees each light, and the light goes on to the
/// material if the result is true.
pub struct WatchedLight<'a, W> {
    lighting: &'a dyn Lighting,
    watch: W,
    /// Whether a material has used the lights.
    is_used: Cell<bool>,
}

impl<'a, W: Fn(&Ray, &Hit, &Illumination) -> bool> WatchedLight<'a, W> {
    pub const fn new(lighting: &'a dyn Lighting, watch: W) -> Self {
        Self {
            lighting,
            watch,
            is_used: Cell::new(false),
        }
    }
}

impl<W: Fn(&Ray, &Hit, &Illumination) -> bool> Lighting for WatchedLight<'_, W> {
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
