//! `spot_light` by the angle itself, from both products.

use crate::prelude::*;

pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let light = PointLight::new(color, lamp).ok()?.illumination(point)?;
    let to_point = -light.direction;
    let angle = libm::atan2(axis.cross(to_point).magnitude(), axis.dot(to_point));
    if angle <= half_angle {
        Some(light)
    } else {
        None
    }
}
