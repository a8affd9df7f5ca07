//! `trace`: the lesson's own tracer.

use crate::prelude::*;

pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}
