//! Turns that end in the wrong frame, or turn to the wrong side.

use a02_math::Vector3;
use a07_transforms::Transform;
use common::ArgumentError;
use testing::exercise::Wrong;

use crate::rotation::check;
use crate::solutions::rotation::rotation;

/// How far the axis is above the plane y = 0, and around from z towards x.
fn up_and_around(k: Vector3) -> (f64, f64) {
    let up = libm::atan2(k.y(), libm::hypot(k.x(), k.z()));
    (up, libm::atan2(k.x(), k.z()))
}

/// The chain of turns about y, x, z, x and y.
fn chain([a, b, angle, c, d]: [f64; 5]) -> Result<Transform, ArgumentError> {
    Transform::IDENTITY
        .rotate_y(a)?
        .rotate_x(b)?
        .rotate_z(angle)?
        .rotate_x(c)?
        .rotate_y(d)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "turned the other way",
        says: "[1, 0, 0] about [0.000, 0.000, 2.000], turned by sine 1.000, cosine 0.000: expected (0, 1, 0), got (",
        check: |c| check(c, |k, angle| rotation(k, -angle)),
    },
    Wrong {
        mistake: "not brought back",
        says: "about [2.000, 0.000, 0.000], turned by sine 0.000, cosine 1.000: expected (1, 0, 0), got (",
        check: |c| {
            check(c, |k, angle| {
                let (up, around) = up_and_around(k);
                chain([0.0, 0.0, angle, up, -around])
            });
        },
    },
    Wrong {
        mistake: "the chain read from above",
        says: "about [2.000, 0.000, 0.000], turned by sine 1.000, cosine 0.000: expected",
        check: |c| {
            check(c, |k, angle| {
                let (up, around) = up_and_around(k);
                chain([-around, up, angle, -up, around])
            });
        },
    },
    Wrong {
        mistake: "up without its sign, though turns about x lead down",
        says: "about [0.000, 2.000, 0.000], turned by sine 1.000, cosine 0.000: expected (0, 0, -1), got (",
        check: |c| {
            check(c, |k, angle| {
                let (up, around) = up_and_around(k);
                chain([around, up, angle, -up, -around])
            });
        },
    },
    Wrong {
        mistake: "only around, not up",
        says: "about [0.000, 2.000, 0.000], turned by sine 1.000, cosine 0.000: expected (0, 0, -1), got (",
        check: |c| {
            check(c, |k, angle| {
                let (_, around) = up_and_around(k);
                chain([around, 0.0, angle, 0.0, -around])
            });
        },
    },
    Wrong {
        mistake: "the axis's coordinates as angles about x, y and z",
        says: "[1, 0, 0] about [1.200, 0.000, -1.600], turned by sine 1.000, cosine 0.000: expected (0.36",
        check: |c| {
            check(c, |k, angle| {
                let k = k.normalized().unwrap_or(k) * angle;
                Transform::IDENTITY
                    .rotate_x(k.x())?
                    .rotate_y(k.y())?
                    .rotate_z(k.z())
            });
        },
    },
    Wrong {
        mistake: "an arc sine of y that forgets the length",
        says: "about [0.960, 1.200, 1.280], turned by sine 1.000, cosine 0.000: expected (0.2304",
        check: |c| {
            check(c, |k, angle| {
                let (_, around) = up_and_around(k);
                let up = libm::asin(k.y().clamp(-1.0, 1.0));
                chain([around, -up, angle, up, -around])
            });
        },
    },
    Wrong {
        mistake: "an arc tangent that does not know the quadrant",
        says: "about [0.000, 0.000, -2.000], turned by sine 1.000",
        check: |c| {
            check(c, |k, angle| {
                let (up, around) = up_and_around(k);
                let around = if k.z() < 0.0 {
                    libm::atan(k.x() / k.z())
                } else {
                    around
                };
                chain([around, -up, angle, up, -around])
            });
        },
    },
];
