//! `reflected`: the lesson's own.

use a02_math::{Normal3, Vector3};

pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    v.reflected_on(n)
}
