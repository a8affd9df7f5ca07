//! The cone of a spot light: which points it lights.

use a02_math::{Direction, Vector3};
use a05_lighting::{Light, SpotLight};
use common::Color;

use super::{Answered, direction, point};
use crate::Reply;

/// Numbers: the angle of the axis in radians, the half angle in degrees, and a point.
/// The light is at the origin.
pub fn answer([axis, half_angle, x, y]: [f64; 4]) -> Answered {
    let (position, axis, half_angle) = (point(0.0, 0.0), direction(axis), half_angle.to_radians());
    let light = SpotLight::new(Color::WHITE, position, axis, half_angle)?;
    let towards: Vector3 = point(x, y) - position;
    let cosine = towards.normalized().map_or(f64::NAN, |v| v.dot(axis));
    Ok(Reply::default()
        .with("lit", [f64::from(u8::from(light.illuminates(point(x, y))))])
        .with("cosine", [cosine])
        .with("cosine_of_half_angle", [libm::cos(half_angle)])
        .with("angle", [towards.angle(axis).to_degrees()]))
}
