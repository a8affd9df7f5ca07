//! Shares without a sign, of the wrong corner, or of a shadow of the triangle.

use a02_math::{Direction, Point3};
use testing::exercise::Wrong;

use crate::barycentric::check;
use crate::solutions::barycentric::barycentric;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "areas without their sign",
        says: "of [-0.5, -0.5, 0], in the plane, in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]: expected (2, -0.5, -0.5), got (0, 0.5, 0.5)",
        check: |c| {
            check(c, |p, corners| {
                let [_, beta, gamma] = barycentric(p, corners)?.map(f64::abs);
                Some([1.0 - beta - gamma, beta, gamma])
            });
        },
    },
    Wrong {
        mistake: "the shares of b and c exchanged",
        says: "of [1, 0, 0], in the plane, in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]: expected (0, 1, 0), got (0, 0, 1)",
        check: |c| {
            check(c, |p, corners| {
                barycentric(p, corners).map(|[a, b, c]| [a, c, b])
            });
        },
    },
    Wrong {
        mistake: "divided by the area instead of its square",
        says: "in [[5.0, 2.0, 1.0], [3.0, 4.0, 0.0], [7.0, 3.0, -1.0]]",
        check: |c| {
            check(c, |p, [a, b, c]| {
                let whole = (b - a).cross(c - a).magnitude();
                let [_, beta, gamma] = barycentric(p, [a, b, c])?.map(|share| share * whole);
                Some([1.0 - beta - gamma, beta, gamma])
            });
        },
    },
    Wrong {
        mistake: "z left out",
        says: "of [2.75, -2.5, -3.5], above, in [[5.0, 2.0, 1.0], [3.0, 4.0, 0.0], [7.0, 3.0, -1.0]]: expected (1, 0, 0), got (4.375",
        check: |c| {
            check(c, |p, corners| {
                let flat = |p: Point3| Point3::new(p.x(), p.y(), 0.0);
                barycentric(flat(p), corners.map(flat))
            });
        },
    },
    Wrong {
        mistake: "areas of the triangles to p, which grow beside the plane",
        says: "above, in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]: expected (1, 0, 0), got",
        check: |c| {
            check(c, |p, [a, b, c]| {
                let n = (b - a).cross(c - a);
                let whole = n.magnitude();
                let share =
                    |area: a02_math::Vector3| area.magnitude().copysign(area.dot(n)) / whole;
                let beta = share((p - a).cross(c - a));
                let gamma = share((b - a).cross(p - a));
                (whole > 0.0).then_some([1.0 - beta - gamma, beta, gamma])
            });
        },
    },
    Wrong {
        mistake: "a division by 0 for corners on a line",
        says: "shares of the corner a on a line of corners, the third 0 steps away: expected none, got (NaN, NaN, NaN)",
        check: |c| {
            check(c, |p, corners| {
                barycentric(p, corners).or(Some([f64::NAN; 3]))
            });
        },
    },
    Wrong {
        mistake: "a small triangle taken for a line",
        says: "in [[0.0, 0.0, 0.0], [0.0, 1e-5, 0.0], [0.0, 0.0, 2e-5]]: expected (1, 0, 0), got none",
        check: |c| {
            check(c, |p, [a, b, c]| {
                let whole = (b - a).cross(c - a).magnitude();
                (whole > 1e-6).then(|| barycentric(p, [a, b, c]))?
            });
        },
    },
    Wrong {
        mistake: "shares held between 0 and 1",
        says: "expected (-0.5, 1.25, 0.25), got (0, 1, 0.25)",
        check: |c| {
            check(c, |p, corners| {
                Some(barycentric(p, corners)?.map(|share| share.clamp(0.0, 1.0)))
            });
        },
    },
];
