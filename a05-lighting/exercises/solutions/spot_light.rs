//! A cone of light: the lesson's `SpotLight`.

use crate::prelude::*;

pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let spot = SpotLight::new(color, lamp, axis, half_angle);
    spot.ok()?.illumination(point)
}
