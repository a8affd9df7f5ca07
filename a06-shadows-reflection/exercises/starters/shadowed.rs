//! `is_shadowed`: whether an object lies between a hit and a light.
//!
//! Chapter: Shadows and reflection, section "Is the light in sight?". To compare
//! afterwards: `a06-shadows-reflection/src/shadow.rs`.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use a05_lighting::Illumination;
use a06_shadows_reflection::{Surface, secondary_ray};

/// Whether any object of the world lies between the hit of `ray` and a light, whose
/// direction and distance `light` holds.
///
/// `secondary_ray(ray, hit, direction)` is a ray that leaves the surface of a hit without
/// hitting it again; `world.is_hit(&ray, within)` says whether any object is hit.
pub fn is_shadowed(
    world: &World<Box<dyn Surface>>,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> bool {
    testing::missing("whether an object lies between", false)
}
