//! Angles that depend on lengths, on one half of the sky, or on rounding.

use a02_math::{Direction, Vector3};
use testing::exercise::Wrong;

use crate::rings::check;
use crate::solutions::rings::ring;

fn arc_cosine(direction: Vector3, pole: Vector3) -> f64 {
    let lengths = direction.magnitude() * pole.magnitude();
    libm::acos((direction.dot(pole) / lengths).clamp(-1.0, 1.0))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "rounded to the nearest",
        says: "0.5 rings of 7.854e-1 radians from the pole, which is [0, 1, 0], direction of length 1: expected 0, got 1",
        check: |c| check(c, |d, pole, width| (d.angle(pole) / width).round() as u32),
    },
    Wrong {
        mistake: "counted from 1",
        says: "0.5 rings of 7.854e-1 radians from the pole, which is [0, 1, 0], direction of length 1: expected 0, got 1",
        check: |c| check(c, |d, pole, width| ring(d, pole, width) + 1),
    },
    Wrong {
        mistake: "a cosine that is not divided by the lengths",
        says: "which is [0, 3, 0], direction of length 0.2: expected 0, got 1",
        check: |c| {
            check(c, |d, pole, width| {
                (libm::acos(d.dot(pole).clamp(-1.0, 1.0)) / width) as u32
            });
        },
    },
    Wrong {
        mistake: "the arc cosine, which small angles are lost in",
        says: "rings of 1.000e-9 radians from the pole",
        check: |c| check(c, |d, pole, width| (arc_cosine(d, pole) / width) as u32),
    },
    Wrong {
        mistake: "the angle to the line of the pole, the same on both sides",
        says: "2.5 rings of 7.854e-1 radians from the pole, which is [0, 1, 0], direction of length 1: expected 2, got 1",
        check: |c| {
            check(c, |d, pole, width| {
                let behind = d.dot(pole) < 0.0;
                ring(d, if behind { -pole } else { pole }, width)
            });
        },
    },
    Wrong {
        mistake: "degrees",
        says: "0.5 rings of 7.854e-1 radians from the pole, which is [0, 1, 0], direction of length 1: expected 0, got 28",
        check: |c| {
            check(c, |d, pole, width| {
                (d.angle(pole).to_degrees() / width) as u32
            });
        },
    },
    Wrong {
        mistake: "the pole always up",
        says: "from the pole, which is [0.6, 0, -0.8], direction of length 1: expected 0, got 2",
        check: |c| check(c, |d, _, width| ring(d, Vector3::new(0.0, 1.0, 0.0), width)),
    },
    Wrong {
        mistake: "the distance of the tips instead of the angle",
        says: "1.0001 rings of 7.854e-1 radians from the pole, which is [0, 1, 0], direction of length 1: expected 1, got 0",
        check: |c| {
            check(c, |d, pole, width| {
                let between = d
                    .normalized()
                    .zip(pole.normalized())
                    .map(|(d, pole)| d - pole);
                (between.map_or(0.0, Vector3::magnitude) / width) as u32
            });
        },
    },
];
