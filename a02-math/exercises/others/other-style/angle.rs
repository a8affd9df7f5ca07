//! `angle` by the arc sine where it is steep, and by the arc cosine elsewhere.

use crate::prelude::*;

pub fn angle(a: Vector3, b: Vector3) -> f64 {
    let (Some(a), Some(b)) = (a.normalized(), b.normalized()) else {
        return 0.0;
    };
    let (sine, cosine) = (a.cross(b).magnitude(), a.dot(b));
    if sine > 0.7 {
        libm::acos(cosine)
    } else if cosine > 0.0 {
        libm::asin(sine)
    } else {
        std::f64::consts::PI - libm::asin(sine)
    }
}
