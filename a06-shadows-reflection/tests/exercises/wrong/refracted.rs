//! Light that only gets in, or that bends to the wrong side.

use a02_math::{Direction, Normal3, Vector3};
use testing::exercise::Wrong;

use crate::refracted::check;
use crate::solutions::refracted::refracted;

/// Snell's law with a normal against the light, and this ratio.
fn bent(d: Vector3, n: Normal3, ratio: f64) -> Option<Vector3> {
    let cos = -d.dot(n);
    let squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
    (squared >= 0.0).then(|| d * ratio + n * (ratio * cos - squared.sqrt()))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "only the way in",
        says: "out of water, index 1.3333333333333333, direction [0.6, 0.8, 0]: expected (0.8, 0.6, 0), got (0.44999999",
        check: |c| check(c, |d, n, index| bent(d, n, 1.0 / index)),
    },
    Wrong {
        mistake: "the normal turned, but not the ratio",
        says: "out of water, index 1.3333333333333333, direction [0.6, 0.8, 0]: expected (0.8, 0.6, 0), got (0.44999999",
        check: |c| {
            check(c, |d, n, index| {
                bent(d, if d.dot(n) > 0.0 { -n } else { n }, 1.0 / index)
            });
        },
    },
    Wrong {
        mistake: "the ratio upside down",
        says: "into water, index 1.3333333333333333, direction [0.8, -0.6, 0]: expected (0.6, -0.8, 0), got none",
        check: |c| check(c, |d, n, index| refracted(d, n, 1.0 / index)),
    },
    Wrong {
        mistake: "a number for total reflection",
        says: "out of water at too large an angle, index 1.3333333333333333, direction [0.8, 0.6, 0]: expected none, got (NaN",
        check: |c| {
            check(c, |d, n, index| {
                refracted(d, n, index).or(Some(Vector3::new(f64::NAN, 0.0, 0.0)))
            });
        },
    },
    Wrong {
        mistake: "mirrored where no light gets out",
        says: "out of water at too large an angle, index 1.3333333333333333, direction [0.8, 0.6, 0]: expected none, got (0.8, -0.6, 0)",
        check: |c| {
            check(c, |d, n, index| {
                refracted(d, n, index).or(Some((-d).reflected_on(n)))
            });
        },
    },
    Wrong {
        mistake: "the light back on the side that it comes from",
        says: "into water, index 1.3333333333333333, direction [0.8, -0.6, 0]: expected (0.6, -0.8, 0), got (0.6",
        check: |c| {
            check(c, |d, n, index| {
                let new = refracted(d, n, index)?;
                Some(new - Vector3::from(n) * (2.0 * new.dot(n)))
            });
        },
    },
    Wrong {
        mistake: "angles divided instead of sines",
        says: "into water, index 1.3333333333333333, direction [0.8, -0.6, 0]: expected (0.6, -0.8, 0), got (0.64",
        check: |c| {
            check(c, |d, n, index| {
                let exact = refracted(d, n, index)?;
                let leaves = d.dot(n) > 0.0;
                let along = if leaves {
                    Vector3::from(n)
                } else {
                    -Vector3::from(n)
                };
                let Some(aside) = (d - along * d.dot(along)).normalized() else {
                    return Some(exact);
                };
                let angle = libm::acos(d.dot(along).min(1.0));
                let (sin, cos) = libm::sincos(if leaves { angle * index } else { angle / index });
                Some(aside * sin + along * cos)
            });
        },
    },
    Wrong {
        mistake: "a normal always up",
        says: "in, index ",
        check: |c| {
            check(c, |d, _, index| {
                refracted(d, Normal3::new(0.0, 1.0, 0.0), index)
            });
        },
    },
    Wrong {
        mistake: "the index of water",
        says: "into air, index 1, direction [0.6, -0.8, 0]: expected (0.6, -0.8, 0), got",
        check: |c| check(c, |d, n, _| refracted(d, n, 4.0 / 3.0)),
    },
];
