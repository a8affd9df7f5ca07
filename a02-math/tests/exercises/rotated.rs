//! Rotations about axes of all lengths.

use crate::prelude::*;

yours! { rotated }

pub fn exercise() -> Exercise<fn(Vector3, Vector3, f64) -> Vector3> {
    Exercise::asked(|rotated, (v, axis, angle)| array(rotated(vector(v), vector(axis), angle)))
}
