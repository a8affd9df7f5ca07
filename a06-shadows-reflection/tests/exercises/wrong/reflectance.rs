//! Shares of one polarisation, of amplitudes, or nearly right ones.

use testing::exercise::Wrong;

use crate::reflectance::check;
use crate::solutions::reflectance::reflectance;

/// The amplitudes of both polarisations, across and along; none if all is mirrored.
fn amplitudes(cos: f64, from: f64, to: f64) -> Option<[f64; 2]> {
    let ratio = from / to;
    let squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
    let beyond = (squared > 0.0).then(|| squared.sqrt())?;
    let amplitude = |a: f64, b: f64| (a - b) / (a + b);
    Some([
        amplitude(from * cos, to * beyond),
        amplitude(from * beyond, to * cos),
    ])
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "Schlick's approximation",
        says: "aslant into water: cosine 0.6, from the index 1 to 1.3333333333333333: expected 0.0392, got 0.0304",
        check: |c| {
            check(c, |cos, from, to| {
                let straight = (from - to) / (from + to);
                let straight = straight * straight;
                straight + (1.0 - straight) * libm::pow(1.0 - cos, 5.0)
            });
        },
    },
    Wrong {
        mistake: "only one polarisation, across",
        says: "aslant into water: cosine 0.6, from the index 1 to 1.3333333333333333: expected 0.0392, got 0.078",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(1.0, |[across, _]| across * across)
            });
        },
    },
    Wrong {
        mistake: "only one polarisation, along",
        says: "aslant into water: cosine 0.6, from the index 1 to 1.3333333333333333: expected 0.0392, got 4.8",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(1.0, |[_, along]| along * along)
            });
        },
    },
    Wrong {
        mistake: "amplitudes that are not squared",
        says: "straight into water: cosine 1, from the index 1 to 1.3333333333333333: expected 0.0204",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(1.0, |[a, b]| f64::midpoint(a.abs(), b.abs()))
            });
        },
    },
    Wrong {
        mistake: "the sum of both polarisations, not half of it",
        says: "straight into water: cosine 1, from the index 1 to 1.3333333333333333: expected 0.0204",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(1.0, |[a, b]| a * a + b * b)
            });
        },
    },
    Wrong {
        mistake: "no total reflection",
        says: "total reflection: cosine 0.6, from the index 1.3333333333333333 to 1: expected 1, got NaN",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(f64::NAN, |[a, b]| f64::midpoint(a * a, b * b))
            });
        },
    },
    Wrong {
        mistake: "nothing mirrored where all is",
        says: "total reflection: cosine 0.6, from the index 1.3333333333333333 to 1: expected 1, got 0",
        check: |c| {
            check(c, |cos, from, to| {
                amplitudes(cos, from, to).map_or(0.0, |[a, b]| f64::midpoint(a * a, b * b))
            });
        },
    },
    Wrong {
        mistake: "0 divided by 0 along no surface",
        says: "a number along no surface at all: cosine 0, from the index 1.5 to 1.5: expected 1, got NaN",
        check: |c| {
            check(c, |cos, from, to| {
                let nothing = cos == 0.0 && from == to;
                reflectance(cos, from, to) * if nothing { f64::NAN } else { 1.0 }
            });
        },
    },
    Wrong {
        mistake: "both indices exchanged",
        says: "aslant into water: cosine 0.6, from the index 1 to 1.3333333333333333: expected 0.0392, got 1",
        check: |c| check(c, |cos, from, to| reflectance(cos, to, from)),
    },
    Wrong {
        mistake: "an angle taken for its cosine",
        says: "straight into water: cosine 1, from the index 1 to 1.3333333333333333: expected 0.0204",
        check: |c| check(c, |cos, from, to| reflectance(libm::cos(cos), from, to)),
    },
    Wrong {
        mistake: "always between air and water",
        says: "straight into glass: cosine 1, from the index 1 to 1.5: expected 0.04, got 0.0204",
        check: |c| {
            check(c, |cos, from, to| {
                let water = 4.0 / 3.0;
                if from < to {
                    reflectance(cos, 1.0, water)
                } else {
                    reflectance(cos, water, 1.0)
                }
            });
        },
    },
];
