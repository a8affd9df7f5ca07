//! Skies that end at the horizon, or stand on their head.

use common::Color;
use testing::exercise::{Check, Wrong};

use crate::hemisphere::check;
use crate::own::Own;

/// A material whose colour is made of diffuse colour, sky, ground and the cosine
/// between normal and up.
fn material(c: &mut Check, color: fn([Color; 3], f64) -> Color) {
    check(c, |diffuse, sky, ground| {
        Ok(Own(
            move |_: &_, hit: &a04_intersections::Hit, _: &dyn a05_lighting::Lighting| {
                color([diffuse, sky, ground], hit.normal.y())
            },
        ))
    });
}

/// The mean of sky and ground, with this share of the sky.
fn mixed([diffuse, sky, ground]: [Color; 3], share: f64) -> Color {
    diffuse * (sky * share + ground * (1.0 - share))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the cosine itself as the share",
        says: "normal [0.000, -1.000, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.4, 0.1, 0), got (0.6",
        check: |c| material(c, mixed),
    },
    Wrong {
        mistake: "no sky below the horizon",
        says: "normal [1.000, 0.000, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.3",
        check: |c| material(c, |colors, cosine| mixed(colors, cosine.max(0.0))),
    },
    Wrong {
        mistake: "sky and ground exchanged",
        says: "normal [0.000, 1.000, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.2, 0.3, 0.25), got (0.4, 0.1, 0)",
        check: |c| {
            material(c, |colors, cosine| {
                mixed(colors, f64::midpoint(1.0, -cosine))
            });
        },
    },
    Wrong {
        mistake: "without the diffuse colour",
        says: "expected (0.2, 0.3, 0.25), got (0.2, 0.6, 1)",
        check: |c| {
            material(c, |[_, sky, ground], cosine| {
                mixed([Color::WHITE, sky, ground], f64::midpoint(1.0, cosine))
            });
        },
    },
    Wrong {
        mistake: "the angle instead of the cosine",
        says: "normal [0.800, 0.600, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.24",
        check: |c| {
            material(c, |colors, cosine| {
                mixed(colors, 1.0 - libm::acos(cosine) / std::f64::consts::PI)
            });
        },
    },
    Wrong {
        mistake: "half of the sum of both",
        says: "normal [0.000, 1.000, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.2, 0.3, 0.25), got (0.3",
        check: |c| material(c, |colors, _| mixed(colors, 0.5)),
    },
    Wrong {
        mistake: "the same from above and below",
        says: "normal [0.000, -1.000, 0.000], diffuse [1.0, 0.5, 0.25], sky [0.2, 0.6, 1.0], ground [0.4, 0.2, 0.0]: expected (0.4, 0.1, 0), got (0.2",
        check: |c| {
            material(c, |colors, cosine| {
                mixed(colors, f64::midpoint(1.0, cosine.abs()))
            });
        },
    },
];
