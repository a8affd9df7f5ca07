//! A matt surface, equally bright from every direction.

use crate::prelude::*;

/// The light that a surface of this diffuse colour reflects from the hit back along the ray:
/// of the ambient light and of each light that reaches the hit.
///
/// `lighting.ambient()` is the colour of the ambient light, and `lighting.for_each_light(ray, hit, &mut |light| …)`
/// calls a function with each light that reaches the hit: its `color`, and its `direction`, which leads to it and
/// has length 1. `a.dot(b)` is a dot product.
pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    // 1. Begin with the ambient light.
    // 2. For each light that reaches the hit, find the cosine to the normal; none from behind.
    // 3. Add the part of its colour that the surface reflects.
    missing!("the reflected light", Color::BLACK, {
        let mut color = diffuse * lighting.ambient();
        lighting.for_each_light(ray, hit, &mut |light| {
            let cosine = hit.normal.dot(light.direction).max(0.0);
            color += diffuse * light.color * cosine;
        });
        color
    })
}

testing::examples! {
    let lit = |ambient, from: Vector3| {
        let sun = DirectionalLight::new(Color::gray(2.0), -from).unwrap();
        let lights = LitWorld::new(Color::BLACK, ambient).unwrap().lit_by(Box::new(sun));
        let ray = Ray::derived(Point3::new(0.0, 1.0, 0.0), Vector3::new(0.0, -1.0, 0.0));
        let hit = Hit::new(1.0, Normal3::new(0.0, 1.0, 0.0));
        lambert(Color::new(1.0, 0.5, 0.0), &ray, &hit, &lights).channels()
    };
    let up = Vector3::new(0.0, 1.0, 0.0);
    assert_close!(lit(Color::BLACK, up), [2.0, 1.0, 0.0], "light from above");
    assert_close!(lit(Color::BLACK, Vector3::new(4.0, 3.0, 0.0)), [1.2, 0.6, 0.0]);
    assert_close!(lit(Color::BLACK, -up), [0.0; 3], "light from behind");
    assert_close!(lit(Color::WHITE, -up), [1.0, 0.5, 0.0], "ambient light");
}
