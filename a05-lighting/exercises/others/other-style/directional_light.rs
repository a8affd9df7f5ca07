//! `directional_light` as what becomes of the direction.

use crate::prelude::*;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    direction.normalized().map(|along| Illumination {
        color,
        direction: -along,
        distance: f64::INFINITY,
    })
}
