//! `directional_light` by the length of the direction.

use crate::prelude::*;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let length = direction.magnitude();
    if length == 0.0 {
        return None;
    }
    Some(Illumination {
        color,
        direction: direction * (-1.0 / length),
        distance: f64::INFINITY,
    })
}
