//! `phong` with the eye's direction mirrored, instead of that of each light.

use crate::prelude::*;

pub fn phong(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
) -> Color {
    let (n, to_eye) = (Vector3::from(hit.normal), -ray.direction());
    let mirrored_eye = n * (2.0 * n.dot(to_eye)) - to_eye;
    let mut color = diffuse * lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| {
        let cosine = n.dot(light.direction);
        if cosine > 0.0 {
            let highlight = libm::pow(mirrored_eye.dot(light.direction).max(0.0), exponent);
            color += (diffuse * cosine + specular * highlight) * light.color;
        }
    });
    color
}
