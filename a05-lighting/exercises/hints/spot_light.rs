//! A light that shines from one point into a cone.

use crate::prelude::*;

/// The light of a lamp that arrives at a point in the cone around `axis`, which has length 1
/// and leads away from the lamp. The half angle is in radians, up to π.
///
/// `libm::cos(x)` is a cosine.
pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let light = PointLight::new(color, lamp).ok()?.illumination(point)?;
    let cosine = axis.dot(-light.direction).max(-1.0);
    let is_in_cone = cosine >= libm::cos(half_angle);
    is_in_cone.then_some(light)
}
