//! Points and vectors from arrays of numbers, as tables of inputs write them, and back.

use crate::{Point3, Vector3};

/// The vector with these coordinates.
#[must_use]
pub const fn vector([x, y, z]: [f64; 3]) -> Vector3 {
    Vector3::new(x, y, z)
}

/// The point with these coordinates.
#[must_use]
pub const fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

/// The vector of length 1 with this direction; all zeros where there is none.
#[must_use]
pub fn unit(xyz: [f64; 3]) -> Vector3 {
    vector(xyz).normalized().unwrap_or_default()
}

/// The coordinates of a point, a vector or a normal.
#[must_use]
pub fn array(triple: impl Into<[f64; 3]>) -> [f64; 3] {
    triple.into()
}
