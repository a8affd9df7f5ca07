//! A sky of rings.

use a02_math::Vector3;

/// The ring that a ray in the `direction` meets: 0 around the `pole`, 1 around
/// that, and so on. All of them are as wide as the angle `width`, in radians.
/// Directions have any length but 0.
pub fn ring(direction: Vector3, pole: Vector3, width: f64) -> u32 {
    (direction.angle(pole) / width) as u32
}
