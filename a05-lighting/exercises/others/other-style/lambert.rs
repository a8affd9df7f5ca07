//! `lambert` over a list of the lights from the front.

use crate::prelude::*;

pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let mut parts = vec![diffuse * lighting.ambient()];
    lighting.for_each_light(ray, hit, &mut |light| {
        let cosine = hit.normal.dot(light.direction);
        if cosine > 0.0 {
            parts.push(diffuse * (light.color * cosine));
        }
    });
    parts.into_iter().fold(Color::BLACK, |sum, part| sum + part)
}
