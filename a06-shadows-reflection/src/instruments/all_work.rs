//! A tracer that leaves nothing out, for the comparison with the lesson: it
//! follows reflected rays through black mirrors, and sends shadow rays to lights
//! that are behind the surface or cast no shadows.

use std::cell::Cell;

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a05_lighting::{Illumination, Light, Lighting};
use common::Color;

use crate::shadow::ShadowRay;
use crate::{ShadowedWorld, secondary_ray};

/// Computes the same colours as [`RecursiveTracer`](crate::RecursiveTracer) in this world.
#[derive(Clone, Copy)]
pub struct NaiveTracer<'a>(pub &'a ShadowedWorld);

impl NaiveTracer<'_> {
    /// The colour that a ray brings back if it may hit `depth` surfaces in turn.
    pub fn trace(self, ray: &Ray, depth: u32) -> Color {
        let mut ray = *ray;
        let mut color = Color::BLACK;
        let mut mirrored = Color::WHITE;
        for _ in 0..depth {
            let Some((hit, surface)) = self.0.objects().hit(&ray, Interval::AHEAD) else {
                return color + mirrored * self.0.objects().background();
            };
            color += mirrored * surface.color_for(&ray, &hit, &self);
            mirrored = mirrored * surface.mirror_reflectance();
            let direction = (-ray.direction()).reflected_on(hit.normal);
            ray = secondary_ray(&ray, &hit, direction);
        }
        color
    }
}

impl NaiveTracer<'_> {
    /// Whether any object blocks a light: a search that no hit ends.
    fn is_blocked(self, shadow_ray: &ShadowRay) -> bool {
        let is_blocked = Cell::new(false);
        let go_on = |found: &Hit| {
            is_blocked.set(is_blocked.get() || shadow_ray.is_blocked_by(found));
            false
        };
        let (world, before) = (self.0.objects(), shadow_ray.before_the_light());
        let _ = world.any_hit(&shadow_ray.ray, before, &go_on);
        is_blocked.get()
    }
}

impl Lighting for NaiveTracer<'_> {
    fn ambient(&self) -> Color {
        self.0.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        for source in self.0.lights() {
            let Some(light) = source.illumination(point) else {
                continue;
            };
            let is_blocked = self.is_blocked(&ShadowRay::new(ray, hit, &light));
            if !is_blocked || !source.casts_shadows() {
                shade(&light);
            }
        }
    }
}
