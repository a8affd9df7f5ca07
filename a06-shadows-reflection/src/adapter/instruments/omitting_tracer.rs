//! A tracer that leaves out only the work that it is told to, for the comparison with the lesson.
//! With nothing left out it follows reflected rays through black mirrors, and sends shadow rays to
//! lights that are black, behind the surface, or cast no shadows.

use std::cell::Cell;

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a05_lighting::{Illumination, Light, Lighting};
use common::{Color, Omission, Omissions};

use crate::shadow::ShadowRay;
use crate::{ShadowedWorld, mirror_direction, secondary_ray};

/// Computes the same colours as [`RecursiveTracer`](crate::RecursiveTracer) in this world.
#[derive(Clone, Copy)]
pub struct OmittingTracer<'a> {
    pub world: &'a ShadowedWorld,
    /// The work that is left out.
    pub omissions: Omissions,
}

impl OmittingTracer<'_> {
    /// The colour that a ray brings back if it may hit `depth` surfaces in turn.
    pub fn trace(self, ray: &Ray, depth: u32) -> Color {
        let omits_black_mirrors = self.omissions.contains(Omission::BlackMirrors);
        let mut ray = *ray;
        let mut color = Color::BLACK;
        let mut mirrored = Color::WHITE;
        for _ in 0..depth {
            let Some((hit, surface)) = self.world.objects().hit(&ray, Interval::AHEAD) else {
                return color + mirrored * self.world.objects().background();
            };
            color += mirrored * surface.color_for(&ray, &hit, &self);
            mirrored = mirrored * surface.mirror_reflectance();
            if mirrored == Color::BLACK && omits_black_mirrors {
                break;
            }
            ray = secondary_ray(&ray, &hit, mirror_direction(&ray, &hit));
        }
        color
    }

    /// Whether any object blocks a light: a search that the first one ends, or none.
    fn is_blocked(self, shadow_ray: &ShadowRay) -> bool {
        let ends_at_first = self.omissions.contains(Omission::FartherOccluders);
        let is_blocked = Cell::new(false);
        let ends = |found: &Hit| {
            let blocks = shadow_ray.is_blocked_by(found);
            is_blocked.set(is_blocked.get() || blocks);
            blocks && ends_at_first
        };
        let (world, before) = (self.world.objects(), shadow_ray.before_the_light());
        let _ = world.any_hit(&shadow_ray.ray, before, &ends);
        is_blocked.get()
    }
}

impl Lighting for OmittingTracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let omits_black = self.omissions.contains(Omission::UnreflectedLight);
        let omits_behind = self.omissions.contains(Omission::LightsBehind);
        let omits_without_shadows = self.omissions.contains(Omission::LightsWithoutShadows);
        let point = ray.at(hit.t);
        for source in self.world.lights() {
            let Some(light) = source.illumination(point) else {
                continue;
            };
            if omits_black && light.color == Color::BLACK {
                continue;
            }
            if omits_behind && hit.normal.dot(light.direction) <= 0.0 {
                continue;
            }
            let sends_ray = source.casts_shadows() || !omits_without_shadows;
            let is_blocked = sends_ray && self.is_blocked(&ShadowRay::new(ray, hit, &light));
            if !is_blocked || !source.casts_shadows() {
                shade(&light);
            }
        }
    }
}
