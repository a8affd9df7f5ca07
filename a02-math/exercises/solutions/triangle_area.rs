//! The area of a triangle in space.

use a02_math::Point3;

/// The area of the triangle of these corners, in whatever order.
pub fn triangle_area(a: Point3, b: Point3, c: Point3) -> f64 {
    // Half the parallelogram.
    (b - a).cross(c - a).magnitude() / 2.0
}
