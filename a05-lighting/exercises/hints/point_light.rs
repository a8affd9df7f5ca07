//! A light that shines from one point in all directions.

use crate::prelude::*;

/// The light of a lamp that arrives at a point: its colour, the direction of length 1 from
/// the point to the lamp, and the distance. None in the lamp itself.
pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    let to_lamp = lamp - point;
    let direction = to_lamp.normalized()?;
    let distance = to_lamp.magnitude();
    Some(Illumination {
        color,
        direction,
        distance,
    })
}
