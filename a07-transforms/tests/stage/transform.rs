//! Transforms: the steps, their order, their inverses, and normals.

mod normals;
mod refusals;
mod steps;

use a02_math::Point3;
use a07_transforms::Transform;

/// Rounding of a sine, a cosine and their products.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn translated(x: f64, y: f64, z: f64) -> Transform {
    let to = Point3::new(x, y, z);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.scale(x, y, z).unwrap()
}
