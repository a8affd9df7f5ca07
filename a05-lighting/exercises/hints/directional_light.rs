//! A light that shines from infinitely far away, like the sun.

use crate::prelude::*;

/// The light that travels in a direction of any length, as it arrives at every point. None if
/// the direction has no length.
pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let to_light = -direction;
    let direction = to_light.normalized()?;
    let distance = f64::INFINITY;
    Some(Illumination {
        color,
        direction,
        distance,
    })
}
