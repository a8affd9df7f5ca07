//! Where a shadow ray starts above a coarse smooth mesh, after Hanika, "Hacking the
//! Shadow Terminator", Ray Tracing Gems II (2021), chapter 4.

use crate::prelude::*;

/// The start of the shadow rays of a point p on a smooth triangle, above which the curved
/// surface may lie that the triangle stands for.
///
/// The weights are the barycentric coordinates of p: at least 0, and their sum is 1. Each
/// corner has a weight and a normal of length 1, which points to the side of the light. `v.dot(n)` is a
/// dot product, and `Vector3::default()` the zero vector.
pub fn shadow_start(corners: [Point3; 3], normals: [Normal3; 3], weights: [f64; 3]) -> Point3 {
    missing!("the start of the shadow ray", corners[0], {
        let [a, b, c] = corners;
        let p = a + (b - a) * weights[1] + (c - a) * weights[2];
        let mut vector = Vector3::default();
        for corner in 0..3 {
            // How far p lies below the tangent plane of the corner.
            let depth = (corners[corner] - p).dot(normals[corner]);
            // Above the plane, p stays: a hollow casts no shadow on itself here.
            let rise = depth.max(0.0);
            vector = vector + normals[corner] * (weights[corner] * rise);
        }
        p + vector
    })
}

testing::examples! {
    // An edge between two corners of a circle of radius 1, and a third corner behind it.
    let corners = [[-0.6, 0.8, 0.0], [0.6, 0.8, 0.0], [0.0, 0.8, -1.0]].map(point);
    let [left, right, up] = [[-0.6, 0.8, 0.0], [0.6, 0.8, 0.0], [0.0, 1.0, 0.0]]
        .map(|normal| vector(normal).as_normal());
    let start = |normals, weights| array(shadow_start(corners, normals, weights) - Point3::ORIGIN);
    assert_close!(start([up; 3], [0.5, 0.25, 0.25]), [-0.15, 0.8, -0.25]);
    assert_close!(start([left, right, up], [1.0, 0.0, 0.0]), [-0.6, 0.8, 0.0]);
    assert_close!(start([left, right, up], [0.5, 0.5, 0.0]), [0.0, 1.088, 0.0]);
    assert_close!(start([right, left, up], [0.5, 0.5, 0.0]), [0.0, 0.8, 0.0]);
}
