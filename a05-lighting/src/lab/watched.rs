//! Counts powers, by a wrapper around each material; with all work, every material computes
//! the light of all lights, and a Phong material a power for each.

use std::any::Any;
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

/// Wraps this material to count its powers.
pub fn material(material: Box<dyn Material>, all_work: bool) -> Box<dyn Material> {
    Box::new(Watched {
        material,
        as_phong: |material| (material as &dyn Any).downcast_ref(),
        is_lit_from_behind: true,
        all_work,
    })
}

/// A material whose powers are counted.
#[derive(Debug)]
pub struct Watched<M: ?Sized> {
    /// The material.
    pub material: Box<M>,
    /// The material as a Phong material, if it is one.
    pub as_phong: fn(&M) -> Option<&Phong>,
    /// Whether light from behind the surface reaches the material.
    pub is_lit_from_behind: bool,
    /// Whether it does the work that the lesson leaves out.
    pub all_work: bool,
}

impl<M: Material + ?Sized> Material for Watched<M> {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let light = WatchedLight {
            watched: self,
            lighting,
            is_used: Cell::new(false),
        };
        let color = self.material.color_for(ray, hit, &light);
        if self.all_work && !light.is_used.get() {
            light.for_each_light(ray, hit, &mut |_| ());
        }
        color
    }
}

/// Light on its way to a material, which may take a power for it.
struct WatchedLight<'a, M: ?Sized> {
    watched: &'a Watched<M>,
    lighting: &'a dyn Lighting,
    /// Whether the material has used the lights.
    is_used: Cell<bool>,
}

impl<M: ?Sized> Lighting for WatchedLight<'_, M> {
    fn ambient(&self) -> Color {
        self.lighting.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.is_used.set(true);
        let watched = self.watched;
        let phong = (watched.as_phong)(&watched.material);
        self.lighting.for_each_light(ray, hit, &mut |light| {
            if let Some(phong) = phong {
                count_power(phong, watched.all_work, ray, hit, light);
            }
            let is_behind = hit.normal.dot(light.direction) <= 0.0;
            if watched.is_lit_from_behind || !is_behind {
                shade(light);
            }
        });
    }
}

/// Counts the power that a Phong material takes for this light by Phong's condition; with all
/// work, it always takes one.
fn count_power(phong: &Phong, all_work: bool, ray: &Ray, hit: &Hit, light: &Illumination) {
    let (e, l) = (-ray.direction(), light.direction);
    let is_mirrored = hit.normal.dot(l) > 0.0 && e.dot(l.reflected_on(hit.normal)) > 0.0;
    let is_needed = is_mirrored && phong.specular != Color::BLACK;
    if is_needed || all_work {
        tally::count(Work::Power);
    }
    if all_work && !is_needed {
        // The compiler would remove a number that is not used.
        black_box(power(black_box(0.5), phong.exponent));
    }
}
