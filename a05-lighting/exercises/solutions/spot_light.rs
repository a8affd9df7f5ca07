//! A light that shines from one point into a cone.

use crate::prelude::*;

/// The light of a lamp that arrives at a point in the cone around `axis`, which has length 1
/// and leads away from the lamp. The half angle is in radians, up to π.
///
/// `a.dot(b)` is a dot product, and `libm::cos(x)` a cosine.
pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let light = PointLight::new(color, lamp).ok()?.illumination(point)?;
    // 1. Find the cosine of the angle between the axis and the direction to the point.
    // 2. Decide by the half angle whether the point is in the cone.
    // 3. Return the light there, and none elsewhere.
    missing!("whether the point is in the cone", Some(light), {
        let cosine = axis.dot(-light.direction).max(-1.0);
        let is_in_cone = cosine >= libm::cos(half_angle);
        is_in_cone.then_some(light)
    })
}

testing::examples! {
    let is_lit = |half_angle, x, y| {
        let (lamp, down) = (Point3::new(0.0, 4.0, 0.0), Vector3::new(0.0, -1.0, 0.0));
        spot_light(Color::RED, lamp, down, half_angle, Point3::new(x, y, 0.0)).is_some()
    };
    assert!(is_lit(1.0, 4.0, 0.0), "at an angle of 0.79");
    assert!(!is_lit(1.0, 8.0, 0.0), "at an angle of 1.11");
    assert!(!is_lit(1.0, 0.0, 8.0), "behind it");
    assert!(is_lit(2.0, 3.0, 5.0), "behind it, in a wide cone");
}
