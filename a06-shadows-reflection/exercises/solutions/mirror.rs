//! `trace`: the lesson's own tracer.

use a03_rays_cameras::Ray;
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld};
use common::Color;

pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}
