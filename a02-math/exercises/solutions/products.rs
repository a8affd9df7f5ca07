//! `dot` and `cross`: the lesson's own.

use a02_math::{Direction, Vector3};

pub fn dot(a: Vector3, b: Vector3) -> f64 {
    a.dot(b)
}

pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    a.cross(b)
}
