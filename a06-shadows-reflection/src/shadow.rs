//! `is_shadowed`: whether an object lies between a hit and a light.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use a05_lighting::Illumination;

use crate::secondary_ray;
use crate::secondary_ray::rounding_error;

/// Whether any object of the world lies between the hit of `ray` and a light. It
/// need not be the nearest object, so the search ends at the first one.
#[must_use]
// ANCHOR: is-shadowed
pub fn is_shadowed<S>(world: &World<S>, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let shadow_ray = ShadowRay::new(ray, hit, light);
    let blocks = |found: &Hit| shadow_ray.is_blocked_by(found);
    world.any_hit(&shadow_ray.ray, shadow_ray.before_the_light(), &blocks)
}

/// A ray from a hit to a light.
pub(crate) struct ShadowRay {
    pub ray: Ray,
    /// Distance from the hit to the light.
    distance: f64,
    /// Rounding error of the hit. By as much the origin of the ray is offset.
    offset: f64,
}

impl ShadowRay {
    pub fn new(ray: &Ray, hit: &Hit, light: &Illumination) -> Self {
        Self {
            ray: secondary_ray(ray, hit, light.direction),
            distance: light.distance,
            offset: rounding_error(ray, hit),
        }
    }

    pub const fn before_the_light(&self) -> Interval {
        Interval::before(self.distance)
    }

    /// Whether the surface of a hit before the light blocks it. A lamp may be fixed to an
    /// object, a ceiling for example, which must not block it: so the light has to be
    /// farther from the plane that touches the surface at the hit than both ends of the
    /// ray are rounded.
    pub fn is_blocked_by(&self, found: &Hit) -> bool {
        // A surface that holds the light is hit at the distance of the light but for rounding, so
        // only hits in the last sixteenth of the way are asked.
        if found.t < self.distance * (15.0 / 16.0) {
            return true;
        }
        let cosine = self.ray.direction().dot(found.geometric_normal).abs();
        let beyond_the_surface = (self.distance - found.t) * cosine;
        let is_in_the_surface =
            beyond_the_surface <= self.offset + rounding_error(&self.ray, found);
        !is_in_the_surface
    }
}
// ANCHOR_END: is-shadowed
