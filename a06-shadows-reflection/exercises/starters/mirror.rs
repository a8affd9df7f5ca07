//! `trace`: the colour that a ray brings back from a world of mirrors.
//!
//! Chapter: Shadows and reflection, section "The mirror". To compare afterwards:
//! `a06-shadows-reflection/src/recursive_tracer.rs`.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
use a05_lighting::Material;
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld, Surface, secondary_ray};
use common::Color;

/// The colour that a ray brings back if it may hit `depth` surfaces in turn. The last of
/// them mirrors black.
///
/// `world.objects()` has `hit(&ray, within)`, the nearest hit and its surface, and
/// `background()`. A surface has `color_for(&ray, &hit, &lights)`, its own colour, and
/// `reflection()`, the share of the light that it mirrors.
/// `secondary_ray(&ray, &hit, direction)` is a ray that leaves the surface.
pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    let lights = RecursiveTracer::new(world);
    testing::missing("the colour of the ray", Color::BLACK)
}
