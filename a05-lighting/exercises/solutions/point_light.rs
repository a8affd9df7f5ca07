//! A lamp: the lesson's `PointLight`.

use crate::prelude::*;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    PointLight::new(color, lamp).ok()?.illumination(point)
}
