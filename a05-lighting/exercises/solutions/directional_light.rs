//! A far light: the lesson's `DirectionalLight`.

use a02_math::{Point3, Vector3};
use a05_lighting::{DirectionalLight, Illumination, Light};
use common::Color;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let sun = DirectionalLight::new(color, direction);
    sun.ok()?.illumination(Point3::ORIGIN)
}
