//! A far light: the lesson's `DirectionalLight`.

use crate::prelude::*;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let sun = DirectionalLight::new(color, direction);
    sun.ok()?.illumination(Point3::ORIGIN)
}
