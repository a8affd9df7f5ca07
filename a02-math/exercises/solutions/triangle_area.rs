//! The area of a triangle in space.

use crate::prelude::*;

/// The area of the triangle of these corners, in whatever order.
///
/// `u.cross(v)` is a cross product, and `v.magnitude()` the length of a vector.
pub fn triangle_area(a: Point3, b: Point3, c: Point3) -> f64 {
    missing!("the area of the triangle", f64::NAN, {
        // Half the parallelogram.
        (b - a).cross(c - a).magnitude() / 2.0
    })
}

testing::examples! {
    let a = Point3::new(7.0, -1.0, 2.0);
    let area = |b, c| triangle_area(a, a + b, a + c);
    let right = [Vector3::new(3.0, 0.0, 0.0), Vector3::new(0.0, 4.0, 0.0)];
    let aslant = [Vector3::new(2.0, 1.0, -2.0), Vector3::new(-2.0, 2.0, -1.0)];
    assert_close!(area(right[0], right[1]), 6.0);
    assert_close!(area(right[1], right[0]), 6.0);
    assert_close!(area(aslant[0], aslant[1]), 4.5);
}
