//! Fog that ends, that is black, or that is not there.

use testing::exercise::{Check, Wrong};

use crate::fogged::check;

/// The mixture of both colours by the share that is left, made of density and distance.
fn mixed(c: &mut Check, left: fn(f64, f64) -> f64) {
    check(c, |color, fog, density, distance| {
        let left = if density == 0.0 {
            1.0
        } else {
            left(density, distance)
        };
        color * left + fog * (1.0 - left)
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "no fog at all times infinity",
        says: "without fog, at the distance inf: expected (1, 0.5, 0), got (NaN, NaN, NaN)",
        check: |c| {
            check(c, |color, fog, density, distance| {
                let left = libm::exp(-density * distance);
                color * left + fog * (1.0 - left)
            });
        },
    },
    Wrong {
        mistake: "thickening in a straight line",
        says: "at 1 times the distance 0.25, which halves the colour: expected (0.5, 0.5, 0.5), got (0.306",
        check: |c| mixed(c, |density, distance| (1.0 - density * distance).max(0.0)),
    },
    Wrong {
        mistake: "a power of 2 instead of e",
        says: "at 1 times the distance 0.25, which halves the colour: expected (0.5, 0.5, 0.5), got (0.61",
        check: |c| mixed(c, |density, distance| libm::exp2(-density * distance)),
    },
    Wrong {
        mistake: "the exponent without its sign",
        says: "at 1 times the distance 0.25, which halves the colour: expected (0.5, 0.5, 0.5), got (2, 0.5, -1)",
        check: |c| {
            mixed(c, |density, distance| {
                if distance.is_finite() {
                    libm::exp(density * distance)
                } else {
                    0.0
                }
            });
        },
    },
    Wrong {
        mistake: "colour and fog exchanged",
        says: "at 0 times the distance 0.25, which halves the colour: expected (1, 0.5, 0), got (0, 0.5, 1)",
        check: |c| mixed(c, |density, distance| 1.0 - libm::exp(-density * distance)),
    },
    Wrong {
        mistake: "the fog's own colour not added",
        says: "which halves the colour: expected (0.5, 0.5, 0.5), got (0.5, 0.25, 0)",
        check: |c| {
            check(c, |color, _, density, distance| {
                color
                    * if density == 0.0 {
                        1.0
                    } else {
                        libm::exp(-density * distance)
                    }
            });
        },
    },
    Wrong {
        mistake: "the square of the distance",
        says: "at 1 times the distance 0.25, which halves the colour",
        check: |c| {
            mixed(c, |density, distance| {
                libm::exp(-density * distance * distance)
            });
        },
    },
    Wrong {
        mistake: "1 / (1 + density distance)",
        says: "at 1 times the distance 0.25, which halves the colour: expected (0.5, 0.5, 0.5), got (0.59",
        check: |c| mixed(c, |density, distance| 1.0 / (1.0 + density * distance)),
    },
];
