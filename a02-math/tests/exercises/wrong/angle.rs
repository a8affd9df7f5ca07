//! Wrong solutions.

use a02_math::{Direction, Vector3};
use testing::exercise::Wrong;

use crate::angle;

fn cosine(a: Vector3, b: Vector3) -> f64 {
    (a.dot(b) / (a.magnitude() * b.magnitude())).clamp(-1.0, 1.0)
}

fn sine(a: Vector3, b: Vector3) -> f64 {
    (a.cross(b).magnitude() / (a.magnitude() * b.magnitude())).clamp(-1.0, 1.0)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the lengths are left out",
        says: "an acute angle",
        check: |c| angle::check(c, |a, b| libm::acos(a.dot(b).clamp(-1.0, 1.0))),
    },
    Wrong {
        mistake: "the arc sine, which has no obtuse angles",
        says: "an obtuse angle",
        check: |c| {
            angle::check(c, |a, b| {
                let sine = sine(a, b);
                if sine.is_nan() { 0.0 } else { libm::asin(sine) }
            });
        },
    },
    Wrong {
        mistake: "the arc cosine, which merges tiny angles",
        says: "a tiny angle",
        check: |c| {
            angle::check(c, |a, b| {
                let cosine = cosine(a, b);
                if cosine.is_nan() {
                    0.0
                } else {
                    libm::acos(cosine)
                }
            });
        },
    },
    Wrong {
        mistake: "degrees",
        says: "a right angle",
        check: |c| angle::check(c, |a, b| a.angle(b).to_degrees()),
    },
    Wrong {
        mistake: "NaN for the zero vector",
        says: "a zero vector",
        check: |c| {
            angle::check(c, |a, b| {
                if b.magnitude() == 0.0 {
                    f64::NAN
                } else {
                    a.angle(b)
                }
            });
        },
    },
];
