//! The formulas of the protocol as it prints them, mistakes included. They
//! are only for comparison, and to render pictures of the mistakes.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Interval, World};
pub use a05_lab::protocol::lambert;
use common::Color;

use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld};

/// Wrong: only the nearest hit is compared with a thousandth, so that the surface
/// itself hides the object that casts the shadow. And `t`, in units of the
/// direction's length, is compared with a distance, so that objects behind the
/// light cast shadows.
pub fn point_light_illuminates<S>(position: Point3, point: Point3, world: &World<S>) -> bool {
    let to_light = position - point;
    let hit = world.hit(&Ray::derived(point, to_light), Interval::AHEAD);
    !hit.is_some_and(|(hit, _)| hit.t < to_light.magnitude() && hit.t > 0.001)
}

/// Wrong: the ray goes from the point away from the light. (The cone aside.)
pub fn spot_light_illuminates<S>(position: Point3, point: Point3, world: &World<S>) -> bool {
    let from_light = point - position;
    let hit = world.hit(&Ray::derived(point, from_light), Interval::AHEAD);
    !hit.is_some_and(|(hit, _)| hit.t < from_light.magnitude())
}

/// Wrong: any hit counts, including a hit of the surface itself.
pub fn directional_light_illuminates<S>(
    direction: Vector3,
    point: Point3,
    world: &World<S>,
) -> bool {
    let ray = Ray::derived(point, -direction);
    world.hit(&ray, Interval::AHEAD).is_none()
}

/// Wrong: the reflection is inside of the sum over the lights. It counts once for
/// each light, and not at all without lights.
pub fn reflection_inside_sum(own: &[f64], k: f64, reflected: f64) -> f64 {
    own.iter().fold(0.0, |sum, own| sum + own + k * reflected)
}

/// The tracer of the protocol.
///
/// Wrong: its one counter is never restored, so it counts rays and not depth; at
/// the limit it returns the background; and the reflected ray begins a thousandth
/// before the hit, also in tiny scenes. Every hit is searched for three times.
pub struct OneCounter<'a> {
    pub world: &'a ShadowedWorld,
    pub recursion: u32,
}

impl OneCounter<'_> {
    pub fn trace(&mut self, ray: &Ray) -> Color {
        let background = self.world.objects().background();
        if self.recursion < 1 {
            return background;
        }
        let search = || self.world.objects().hit(ray, Interval::AHEAD);
        if search().is_none() {
            return background;
        }
        // Searched again for the material, and once more for its argument.
        let (Some((_, surface)), Some((hit, _))) = (search(), search()) else {
            return background;
        };
        self.recursion -= 1;
        let lighting = RecursiveTracer::new(self.world);
        let color = surface.color_for(ray, &hit, &lighting);
        let direction = (-ray.direction()).reflected_on(hit.normal);
        let reflected = Ray::derived(ray.at(hit.t - 0.001), direction);
        color + surface.mirror_reflectance() * self.trace(&reflected)
    }
}
