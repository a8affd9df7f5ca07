//! `phong` as a matt sum and a sum of highlights, which are black by default.

use crate::prelude::*;

pub fn phong(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
) -> Color {
    let mut matt = lighting.ambient();
    let mut shine = Color::BLACK;
    lighting.for_each_light(ray, hit, &mut |light| {
        let is_before = hit.normal.dot(light.direction) > 0.0;
        let factor = f64::from(u8::from(is_before));
        let mirrored = light.direction.reflected_on(hit.normal);
        let cosine = -mirrored.dot(ray.direction());
        matt += light.color * (factor * hit.normal.dot(light.direction));
        if cosine > 0.0 {
            shine += light.color * (factor * libm::pow(cosine, exponent));
        }
    });
    diffuse * matt + specular * shine
}
