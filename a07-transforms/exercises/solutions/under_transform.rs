//! The ray and the normal under a transform.

use crate::prelude::*;

/// The ray in the space of the object. A hit there has the same `t` as around the object,
/// so the direction keeps the length that it has.
///
/// `transform.matrix()` leads from the space of the object to the space around it, and
/// `transform.inverse()` back. Both can be multiplied by a point, and by a vector.
pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    // 1. Bring the origin to the space of the object, as a point.
    // 2. Bring the direction there, as a vector, and keep its length.
    missing!("the ray in the space of the object", *ray, {
        let origin = transform.inverse() * ray.origin();
        let direction = transform.inverse() * ray.direction();
        Ray::derived(origin, direction)
    })
}

/// A normal of the object in the space around it, of length 1, perpendicular to the
/// transformed surface; none if no direction is perpendicular.
///
/// `matrix.transposed()` has rows and columns swapped, and `Vector3::from(n)` is the normal as a vector;
/// `vector.normalized()?.as_normal()` is a normal of length 1.
pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    // 1. Find the matrix that keeps normals perpendicular to the surface.
    // 2. Apply it to the normal.
    // 3. Normalise the result; none if it has no length.
    missing!("the normal in the space around the object", Some(n), {
        let matrix = transform.inverse().transposed();
        let normal = matrix * Vector3::from(n);
        let normal = normal.normalized()?;
        Some(normal.as_normal())
    })
}

testing::examples! {
    let wide = Transform::IDENTITY.scale(2.0, 1.0, 1.0).unwrap();
    let ray = Ray::derived(Point3::new(4.0, 3.0, 0.0), Vector3::new(-2.0, 0.0, 0.0));
    let inner = ray_to_object(&wide, &ray);
    assert_close!(array(inner.origin()), [2.0, 3.0, 0.0]);
    assert_close!(array(inner.direction()), [-1.0, 0.0, 0.0]);
    let normal = |x, y| {
        let n = normal_from_object(&wide, Normal3::new(x, y, 0.0)).unwrap();
        array(n)
    };
    assert_close!(normal(1.0, 0.0), [1.0, 0.0, 0.0]);
    assert_close!(normal(0.8, 0.3), [0.8, 0.6, 0.0]);
}
