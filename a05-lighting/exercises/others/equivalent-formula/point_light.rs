//! `point_light` by the square of the distance.

use crate::prelude::*;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    let way = lamp - point;
    let distance = way.dot(way).sqrt();
    let direction = way * (1.0 / distance);
    (distance > 0.0).then_some(Illumination {
        color,
        direction,
        distance,
    })
}
