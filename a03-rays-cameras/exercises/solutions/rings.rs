//! A sky of rings.

use crate::prelude::*;

/// The ring that a ray in the `direction` meets: 0 around the `pole`, 1 around that, and so
/// on, each as wide as the angle `width` in radians. Directions have any length but 0.
///
/// `a.angle(b)` is the angle between vectors.
pub fn ring(direction: Vector3, pole: Vector3, width: f64) -> u32 {
    missing!("the number of the ring", 0, {
        (direction.angle(pole) / width) as u32
    })
}

testing::examples! {
    let [up, right] = [Vector3::new(0.0, 2.0, 0.0), Vector3::new(1.0, 0.0, 0.0)];
    assert_close!(ring(up, up, 0.5), 0, "at the pole");
    assert_close!(ring(right, up, 0.5), 3, "1.57 radians away");
    assert_close!(ring(-up, up, 0.5), 6, "opposite to it");
    assert_close!(ring(Vector3::new(5e-9, 2.0, 0.0), up, 1e-9), 2, "very near to it");
}
