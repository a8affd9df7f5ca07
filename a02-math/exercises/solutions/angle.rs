//! `angle`: the angle between two vectors.

use crate::prelude::*;

/// The angle between two vectors of any length in radians, from 0 to π. The angle to
/// the zero vector is 0.
///
/// `a.dot(b)`, `a.cross(b)` and `a.magnitude()` are written; of the functions of angles,
/// use the functions of `libm`: `libm::acos(x)`, `libm::atan2(y, x)`.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    // 1. Express the angle by the two products.
    // 2. Let it not depend on the lengths; one of them may be 0.
    // 3. Keep the digits of an angle near 0 or π.
    missing!("the angle", 0.0, {
        let sine = a.cross(b).magnitude();
        // A product of -0, whose angle would be π, becomes 0.
        let cosine = a.dot(b) + 0.0;
        libm::atan2(sine, cosine)
    })
}

testing::examples! {
    let to = |x, y| angle(Vector3::new(2.0, 0.0, 0.0), Vector3::new(x, y, 0.0)).to_degrees();
    assert_close!(to(0.0, 5.0), 90.0);
    assert_close!(to(-1.0, 1.0), 135.0);
    assert_close!(to(0.0, 0.0), 0.0, "the zero vector");
}
