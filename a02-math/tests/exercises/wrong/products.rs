//! Wrong solutions.

use a02_math::{Direction, Vector3};
use testing::exercise::Wrong;

use crate::products;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the factors of the cross product are swapped",
        says: "expected (-3, 6, -3), got (3, -6, 3)",
        check: |c| products::check(c, a02_math::Direction::dot, |a, b| b.cross(a)),
    },
    Wrong {
        mistake: "y of the cross product with the wrong sign",
        says: "a × b",
        check: |c| {
            products::check(c, a02_math::Direction::dot, |a, b| {
                let cross = a.cross(b);
                Vector3::new(cross.x(), -cross.y(), cross.z())
            });
        },
    },
    Wrong {
        mistake: "the products of the coordinates as cross product",
        says: "a × b",
        check: |c| {
            products::check(c, a02_math::Direction::dot, |a, b| {
                Vector3::new(a.x() * b.x(), a.y() * b.y(), a.z() * b.z())
            });
        },
    },
    Wrong {
        mistake: "the cosine in the place of the dot product",
        says: "a · b",
        check: |c| {
            products::check(
                c,
                |a, b| a.dot(b) / a.magnitude() / b.magnitude(),
                Vector3::cross,
            );
        },
    },
    Wrong {
        mistake: "the dot product without z",
        says: "a · b",
        check: |c| products::check(c, |a, b| a.x() * b.x() + a.y() * b.y(), Vector3::cross),
    },
];
