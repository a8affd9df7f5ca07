//! Distances in wrong units, of something else, or without a side.

use a02_math::{Direction, Point3, Vector3};
use testing::exercise::Wrong;

use crate::signed_distance::check;
use crate::solutions::signed_distance::signed_distance;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "not divided by the length of the normal",
        says: "-4 normals of length 3.000 away: expected -12, got -36",
        check: |c| check(c, |a, n, p| (p - a).dot(n)),
    },
    Wrong {
        mistake: "divided by the square of the length",
        says: "-4 normals of length 3.000 away: expected -12, got -4",
        check: |c| check(c, |a, n, p| (p - a).dot(n) / n.dot(n)),
    },
    Wrong {
        mistake: "without a sign",
        says: "from the plane y = -1 to [0, -3, 5]: expected -2, got 2",
        check: |c| check(c, |a, n, p| signed_distance(a, n, p).abs()),
    },
    Wrong {
        mistake: "from p to the plane",
        says: "from the plane y = -1 to [0, 0, 0]: expected 1, got -1",
        check: |c| check(c, |a, n, p| signed_distance(p, n, a)),
    },
    Wrong {
        mistake: "a plane through the origin",
        says: "from the plane y = -1 to [0, 0, 0]: expected 1, got 0",
        check: |c| check(c, |_, n, p| signed_distance(Point3::ORIGIN, n, p)),
    },
    Wrong {
        mistake: "the distance of both points",
        says: "from the plane y = -1 to [0, 0, 0]: expected 1, got 7.07",
        check: |c| {
            check(c, |a, n, p| (p - a).magnitude().copysign((p - a).dot(n)));
        },
    },
    Wrong {
        mistake: "the length of the cross product",
        says: "from the plane y = -1 to [0, 0, 0]: expected 1, got 7",
        check: |c| {
            check(c, |a, n, p| {
                let n = Vector3::from(n);
                (p - a).cross(n).magnitude() / n.magnitude()
            });
        },
    },
];
