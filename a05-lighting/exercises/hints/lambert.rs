//! A matt surface, equally bright from every direction.

use crate::prelude::*;

/// The light that a surface of this diffuse colour reflects from the hit back along the ray:
/// of the ambient light and of each light that reaches the hit.
pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let mut color = diffuse * lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| {
        let cosine = hit.normal.dot(light.direction).max(0.0);
        color += diffuse * light.color * cosine;
    });
    color
}
