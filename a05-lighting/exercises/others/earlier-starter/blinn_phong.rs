//! A highlight by the vector half way between light and eye.

use crate::prelude::*;

/// The light of one lamp that a hit reflects back along the ray:
/// `cd cl max(0, n · l) + cs cl max(0, n · h)^p`.
pub fn blinn_phong(
    [cd, cs]: [Color; 2],
    p: f64,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> Color {
    let n = hit.normal;
    let cosine = n.dot(light.direction);
    if cosine <= 0.0 {
        return Color::BLACK;
    }
    let half = light.direction - ray.direction();
    let length = half.magnitude();
    let highlight = if length > 0.0 {
        n.dot(half) / length
    } else {
        0.0
    };
    cd * light.color * cosine + cs * light.color * libm::pow(highlight.clamp(0.0, 1.0), p)
}

testing::examples! {
    let lit = |p, eye: Vector3, direction| {
        let (ray, up) = (Ray::derived(Point3::ORIGIN, -eye), Normal3::new(0.0, 1.0, 0.0));
        let light = Illumination { color: Color::WHITE, direction, distance: 1.0 };
        blinn_phong([Color::RED, Color::BLUE], p, &ray, &Hit::new(0.0, up), &light).channels()
    };
    let [up, aslant] = [Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.96, 0.28, 0.0)];
    assert_eq!(lit(8.0, up, up), [1.0, 0.0, 1.0], "light and eye above");
    // The vector half way is (0.6, 0.8, 0).
    assert_close(lit(1.0, up, aslant), [0.28, 0.0, 0.8]);
    assert_close(lit(2.0, aslant, up), [1.0, 0.0, 0.64]);
    assert_eq!(lit(0.0, up, -up), [0.0; 3], "light from behind");
}
