//! `RecursiveTracer`: traces shadow rays and reflected rays.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a05_lighting::{Illumination, Light, Lighting, LitWorld};
use common::Color;

use crate::{LightSource, Surface, is_shadowed, mirror_direction, secondary_ray};

/// A world of surfaces that may mirror and lights that may cast shadows.
pub type ShadowedWorld = LitWorld<Box<dyn Surface>, LightSource>;

/// Computes the colours that rays bring back from a world.
#[derive(Clone, Copy, Debug)]
pub struct RecursiveTracer<'a> {
    world: &'a ShadowedWorld,
}

impl<'a> RecursiveTracer<'a> {
    /// A tracer of this world.
    #[must_use]
    pub const fn new(world: &'a ShadowedWorld) -> Self {
        Self { world }
    }

    /// The colour that a ray brings back if it may hit `depth` surfaces in turn.
    /// The last of them mirrors black.
    ///
    /// By its definition this is a recursion: the colour of a surface is
    /// `c + cr f`, with its own colour `c`, its reflectance `cr` as a mirror, and
    /// the colour `f` that the reflected ray brings back. As each surface
    /// reflects one ray only, a loop can carry the product of all `cr` so far
    /// instead, and no depth overflows the stack.
    #[must_use]
    // ANCHOR: trace
    pub fn trace(&self, ray: &Ray, depth: u32) -> Color {
        let mut ray = *ray;
        let mut color = Color::BLACK;
        let mut mirrored = Color::WHITE;
        for _ in 0..depth {
            let Some((hit, surface)) = self.world.objects().hit(&ray, Interval::AHEAD) else {
                return color + mirrored * self.world.objects().background();
            };
            color += mirrored * surface.color_for(&ray, &hit, self);
            mirrored = mirrored * surface.mirror_reflectance();
            if mirrored == Color::BLACK {
                break;
            }
            ray = secondary_ray(&ray, &hit, mirror_direction(&ray, &hit));
        }
        color
    }
    // ANCHOR_END: trace
}

/// The lights that shine on the front of the surface and that no object blocks.
impl Lighting for RecursiveTracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        for source in self.world.lights() {
            let Some(light) = source.illumination(point) else {
                continue;
            };
            if light.color == Color::BLACK || hit.normal.dot(light.direction) <= 0.0 {
                continue;
            }
            let objects = self.world.objects();
            if source.casts_shadows() && is_shadowed(objects, ray, hit, &light) {
                continue;
            }
            shade(&light);
        }
    }
}
