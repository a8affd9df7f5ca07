//! Turns to the wrong side, in wrong units, or not about the axis alone.

use a02_math::{Direction, Vector3};
use testing::exercise::Wrong;

use crate::rotated::check;
use crate::solutions::rotated::rotated;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "turned to the right",
        says: "[1.0, 2.0, 3.0], turned around [1.0, 0.0, 0.0] by 1.5707963267948966: expected (1, -3, 2), got (1, 3, -1.99",
        check: |c| check(c, |v, axis, angle| rotated(v, axis, -angle)),
    },
    Wrong {
        mistake: "an angle in degrees",
        says: "around [1.0, 0.0, 0.0] by 1.5707963267948966: expected (1, -3, 2)",
        check: |c| check(c, |v, axis, angle| rotated(v, axis, angle.to_radians())),
    },
    Wrong {
        mistake: "without the part along the axis",
        says: "[1.0, 2.0, 3.0], turned around [1.0, 0.0, 0.0] by 1.5707963267948966: expected (1, -3, 2)",
        check: |c| {
            check(c, |v, axis, angle| {
                let Some(k) = axis.normalized() else { return v };
                let (sin, cos) = libm::sincos(angle);
                let along = k * k.dot(v);
                (v - along) * cos + k.cross(v) * sin
            });
        },
    },
    Wrong {
        mistake: "the part along the axis turned away, too",
        says: "expected (1, -3, 2)",
        check: |c| {
            check(c, |v, axis, angle| {
                let Some(k) = axis.normalized() else { return v };
                let (sin, cos) = libm::sincos(angle);
                v * cos + k.cross(v) * sin
            });
        },
    },
    Wrong {
        mistake: "an axis that is not made unit",
        says: "around [2.0, -1.0, 2.0] by 3.141592653589793: expected (1.6666666666666667, -3.3333333333333335, -0.3333333333333333), got (23",
        check: |c| {
            check(c, |v, k, angle| {
                let (sin, cos) = libm::sincos(angle);
                if k.dot(v) == 0.0 && k.dot(k) == 0.0 {
                    return v;
                }
                v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
            });
        },
    },
    Wrong {
        mistake: "no answer around no axis",
        says: "[1.0, 2.0, 3.0], turned around [0.0, 0.0, 0.0] by 1: expected (1, 2, 3), got (NaN",
        check: |c| {
            check(c, |v, axis, angle| {
                rotated(v, axis, angle) * (axis.magnitude() / axis.magnitude())
            });
        },
    },
    Wrong {
        mistake: "around z, whatever the axis",
        says: "[1.0, 2.0, 3.0], turned around [1.0, 0.0, 0.0] by",
        check: |c| {
            check(c, |v, _, angle| {
                rotated(v, Vector3::new(0.0, 0.0, 1.0), angle)
            });
        },
    },
    Wrong {
        mistake: "an angle between 0 and half a turn only",
        says: "around [1.0, 1.0, 1.0] by -2.0943951023931953: expected (2, 3, 1), got (3.0",
        check: |c| {
            check(c, |v, axis, angle| {
                let Some(k) = axis.normalized() else { return v };
                let cos = libm::cos(angle);
                let sin = (1.0 - cos * cos).sqrt();
                let along = k * k.dot(v);
                along + (v - along) * cos + k.cross(v) * sin
            });
        },
    },
];
