//! `reflected`: a vector, mirrored by a surface.

use crate::prelude::*;

/// The vector `v`, which points away from a surface, reflected about the normal `n` of
/// length 1: as far from the normal, on its other side.
///
/// `n.dot(v)` is a dot product, and `Vector3::from(n)` the normal as a vector, which has a sum and multiples.
pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    // 1. Split v into the part along the normal and the rest.
    // 2. Reverse the part that changes its side.
    // 3. Add both parts.
    missing!("the reflected vector", v, {
        let along = Vector3::from(n) * n.dot(v);
        let rest = v - along;
        along - rest
    })
}

testing::examples! {
    let on_floor = |x, y| {
        let v = reflected(Vector3::new(x, y, 0.0), Normal3::new(0.0, 1.0, 0.0));
        (v.x(), v.y())
    };
    assert_close!(on_floor(-2.0, 1.0), (2.0, 1.0), "to the other side");
    assert_close!(on_floor(0.0, 1.0), (0.0, 1.0), "along the normal");
    assert_close!(on_floor(3.0, 0.0), (-3.0, 0.0), "along the surface");
}
