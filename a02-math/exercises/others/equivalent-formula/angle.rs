//! `angle` by the rhombus of both directions, whose diagonals are perpendicular: half of the angle. (Kahan, How Futile are Mindless Assessments of Roundoff, 2006, section 12)

use crate::prelude::*;

pub fn angle(a: Vector3, b: Vector3) -> f64 {
    let (Some(a), Some(b)) = (a.normalized(), b.normalized()) else {
        return 0.0;
    };
    2.0 * libm::atan2((a - b).magnitude(), (a + b).magnitude())
}
