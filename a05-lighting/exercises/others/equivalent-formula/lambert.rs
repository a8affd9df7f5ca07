//! `lambert` with the diffuse colour before the sum of all light.

use crate::prelude::*;

pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let mut arriving = lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| {
        arriving += light.color * light.direction.dot(hit.normal).max(0.0);
    });
    diffuse * arriving
}
