//! A lamp: the lesson's `PointLight`.

use a02_math::Point3;
use a05_lighting::{Illumination, Light, PointLight};
use common::Color;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    PointLight::new(color, lamp).ok()?.illumination(point)
}
