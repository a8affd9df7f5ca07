//! Wrong solutions.

use a02_math::{Direction, Vector3};
use testing::exercise::Wrong;

use crate::reflected;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the formula for a vector that points at the surface",
        says: "along the normal",
        check: |c| reflected::check(c, |v, n| -v.reflected_on(n)),
    },
    Wrong {
        mistake: "once the projection instead of twice",
        says: "on the floor; v = [-2.000, 1.000, 0.000]",
        check: |c| reflected::check(c, |v, n| Vector3::from(n) * n.dot(v) - v),
    },
    Wrong {
        mistake: "the projection itself",
        says: "on the floor",
        check: |c| reflected::check(c, |v, n| Vector3::from(n) * n.dot(v)),
    },
    Wrong {
        mistake: "always to the front",
        says: "from behind",
        check: |c| {
            reflected::check(c, |v, n| Vector3::from(n) * (2.0 * n.dot(v).abs()) - v);
        },
    },
];
