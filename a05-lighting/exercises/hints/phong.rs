//! A matt surface with highlights, where it mirrors a light.

use crate::prelude::*;

/// The light that a shiny surface reflects from the hit back along the ray: of the ambient
/// light and, matt and as a highlight, of each light that reaches the hit.
///
/// `l.reflected_on(n)` is a direction mirrored by a surface, and `libm::pow(x, y)` a power.
pub fn phong(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
) -> Color {
    let mut color = diffuse * lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| {
        let cosine = hit.normal.dot(light.direction);
        if cosine <= 0.0 {
            return;
        }
        color += diffuse * light.color * cosine;
        let mirrored = light.direction.reflected_on(hit.normal);
        let cosine_to_eye = mirrored.dot(-ray.direction());
        if cosine_to_eye > 0.0 {
            color += specular * light.color * libm::pow(cosine_to_eye, exponent);
        }
    });
    color
}
