//! `point_light` from the lamp's side, turned at the end.

use crate::prelude::*;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    let from_lamp = point - lamp;
    match from_lamp.normalized() {
        None => None,
        Some(away) => Some(Illumination {
            color,
            direction: -away,
            distance: from_lamp.dot(away),
        }),
    }
}
