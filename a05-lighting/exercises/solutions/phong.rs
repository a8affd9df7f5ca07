//! A matt surface with highlights, where it mirrors a light.

use crate::prelude::*;

/// The light that a shiny surface reflects from the hit back along the ray: of the ambient
/// light and, matt and as a highlight, of each light that reaches the hit.
///
/// `lighting.ambient()` is the colour of the ambient light, and `lighting.for_each_light(ray, hit, &mut |light| …)`
/// calls a function with each light that reaches the hit: its `color`, and its `direction`, which leads to it and
/// has length 1. `a.dot(b)` is a dot product.
/// `l.reflected_on(n)` is a direction mirrored by a surface, `libm::pow(x, y)` a power, and `ray.direction()`
/// leads away from the eye.
pub fn phong(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
) -> Color {
    // 1. Begin with the light of a matt surface.
    // 2. For each light from the front, mirror its direction by the normal.
    // 3. Find the cosine between the mirrored direction and the direction to the eye.
    // 4. Add the highlight: the cosine to the power of the exponent, in its own colour.
    missing!("the reflected light", Color::BLACK, {
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
    })
}

testing::examples! {
    let lit = |from: Vector3, eye: Vector3| {
        let sun = DirectionalLight::new(Color::WHITE, -from).unwrap();
        let lights = LitWorld::new(Color::BLACK, Color::BLACK).unwrap().lit_by(Box::new(sun));
        let hit = Hit::new(1.0, Normal3::new(0.0, 1.0, 0.0));
        let ray = Ray::derived(Point3::ORIGIN + eye, -eye);
        phong([Color::RED, Color::BLUE], 2.0, &ray, &hit, &lights).channels()
    };
    let [right, left] = [0.6, -0.6].map(|x| Vector3::new(x, 0.8, 0.0));
    let up = Vector3::new(0.0, 1.0, 0.0);
    assert_close!(lit(up, up), [1.0, 0.0, 1.0], "mirrored into the eye");
    assert_close!(lit(right, left), [0.8, 0.0, 1.0]);
    assert_close!(lit(right, up), [0.8, 0.0, 0.64]);
    assert_close!(lit(-up, right), [0.0; 3], "light from behind");
}
