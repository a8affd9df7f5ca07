//! Areas of something else, and one that rounding spoils.

use a02_math::{Direction, Point3, Vector3};
use testing::exercise::Wrong;

use crate::solutions::triangle_area::triangle_area;
use crate::triangle_area::check;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the parallelogram, not half of it",
        says: "a to b [3.0, 0.0, 0.0], a to c [0.0, 4.0, 0.0]: expected 6, got 12",
        check: |c| check(c, |p, q, r| 2.0 * triangle_area(p, q, r)),
    },
    Wrong {
        mistake: "half the product of two sides",
        says: "a to b [3.0, 0.0, 0.0], a to c [0.0, 4.0, 0.0]: expected 6, got 7.5",
        check: |c| check(c, |p, q, r| (q - p).magnitude() * (r - p).magnitude() / 2.0),
    },
    Wrong {
        mistake: "the dot product",
        says: "corners a, b, c, a to b [3.0, 0.0, 0.0], a to c [0.0, 4.0, 0.0]: expected 6, got 0",
        check: |c| check(c, |p, q, r| (q - p).dot(r - p) / 2.0),
    },
    Wrong {
        mistake: "only z of the cross product, as in a plane",
        says: "a to c [-2.0, 2.0, -1.0]: expected 4.5, got 3",
        check: |c| check(c, |p, q, r| (q - p).cross(r - p).z().abs() / 2.0),
    },
    Wrong {
        mistake: "corners instead of sides multiplied",
        says: "far away, corners a, b, c",
        check: |c| {
            check(c, |p, q, r| {
                let [_, q, r] = [p, q, r].map(|corner| corner - Point3::ORIGIN);
                q.cross(r).magnitude() / 2.0
            });
        },
    },
    Wrong {
        mistake: "Heron's formula, which cancels where a triangle is flat",
        says: "a to c [0.5, 9.5367431640625e-7, 0.0]: expected",
        check: |c| {
            check(c, |p, q, r| {
                let [a, b, c] = [r - q, p - r, q - p].map(Vector3::magnitude);
                let half = (a + b + c) / 2.0;
                (half * (half - a) * (half - b) * (half - c))
                    .max(0.0)
                    .sqrt()
            });
        },
    },
];
