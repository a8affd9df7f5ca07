//! `spot_light` by the arc cosine, of a cosine that is kept between -1 and 1.

use crate::prelude::*;

pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let light = PointLight::new(color, lamp).ok()?.illumination(point);
    let is_in_cone = |light: &Illumination| {
        let cosine = (point - lamp).dot(axis) / light.distance;
        libm::acos(cosine.clamp(-1.0, 1.0)) <= half_angle
    };
    light.filter(is_in_cone)
}
