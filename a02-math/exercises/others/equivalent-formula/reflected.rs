//! `reflected` as twice the foot of v on the normal, minus v.

use crate::prelude::*;

pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    Vector3::from(n) * (2.0 * n.dot(v)) - v
}
