//! The lights of a world that reach a hit, by your `is_shadowed`. Your `trace` asks it.

use super::*;

pub struct RecursiveTracer<'a> {
    world: &'a ShadowedWorld,
}

impl<'a> RecursiveTracer<'a> {
    pub fn new(world: &'a ShadowedWorld) -> Self {
        Self { world }
    }
}

impl Lighting for RecursiveTracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        for source in self.world.lights() {
            let Some(light) = source.illumination(ray.at(hit.t)) else {
                continue;
            };
            let is_in_front = hit.normal.dot(light.direction) > 0.0;
            if is_in_front && !is_shadowed(self.world.objects(), ray, hit, &light) {
                shade(&light);
            }
        }
    }
}
