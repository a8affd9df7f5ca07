//! Curves close to the curve of sRGB.

use testing::exercise::Wrong;

use crate::solutions::srgb::{decode, encode};
use crate::srgb::check;

/// The curved part, for all light.
fn curved(linear: f64) -> f64 {
    1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
}

/// The curved part of the way back, for all values.
fn curved_back(value: f64) -> f64 {
    libm::pow((value + 0.055) / 1.055, 2.4)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "a power of 2.2 instead of the curve",
        says: "the value of sRGB for 0.28242953648100017 of light, on the curve: expected 0.56796",
        check: |c| check(c, |x| libm::pow(x, 1.0 / 2.2), |v| libm::pow(v, 2.2)),
    },
    Wrong {
        mistake: "no straight part",
        says: "the value of sRGB for 0 of light, the start: expected 0, got -0.055",
        check: |c| check(c, curved, curved_back),
    },
    Wrong {
        mistake: "the border of light also for values",
        says: "the light of the value 0.0129",
        check: |c| {
            check(c, encode, |value| {
                if value <= 0.003_130_8 {
                    value / 12.92
                } else {
                    curved_back(value)
                }
            });
        },
    },
    Wrong {
        mistake: "the border of values also for light",
        says: "the value of sRGB for 0.0316",
        check: |c| {
            check(
                c,
                |light| {
                    if light <= 0.040_45 {
                        12.92 * light
                    } else {
                        curved(light)
                    }
                },
                decode,
            );
        },
    },
    Wrong {
        mistake: "< for <= at the border",
        says: "at the border, 0.0031308 of light",
        check: |c| {
            check(
                c,
                |light| {
                    if light < 0.003_130_8 {
                        12.92 * light
                    } else {
                        curved(light)
                    }
                },
                decode,
            );
        },
    },
    Wrong {
        mistake: "both directions exchanged",
        says: "the value of sRGB for 0.28242953648100017 of light, on the curve: expected 0.56796",
        check: |c| check(c, decode, encode),
    },
    Wrong {
        mistake: "0.055 not added on the way back",
        says: "the light of the value 1, the end: expected 1, got 0.8",
        check: |c| {
            check(c, encode, |value| {
                if value <= 0.040_45 {
                    value / 12.92
                } else {
                    libm::pow(value / 1.055, 2.4)
                }
            });
        },
    },
    Wrong {
        mistake: "2.4 instead of its inverse",
        says: "the value of sRGB for 0.28242953648100017 of light, on the curve: expected 0.56796",
        check: |c| {
            check(
                c,
                |light| {
                    let curved = 1.055 * libm::pow(light, 2.4) - 0.055;
                    if light <= 0.003_130_8 {
                        12.92 * light
                    } else {
                        curved
                    }
                },
                decode,
            );
        },
    },
];
