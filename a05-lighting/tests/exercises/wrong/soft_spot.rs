//! Rims that are too hard, too wide, or behind the lamp.

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light, PointLight};
use testing::exercise::{Check, Wrong};

use crate::own::Own;
use crate::soft_spot::check;
use crate::solutions::soft_spot::SoftSpot;

/// A spot whose share is made of the angle, the inner and the outer one.
fn share(c: &mut Check, share: fn(f64, f64, f64) -> f64) {
    check(c, |color, position, direction, inner, outer| {
        let source = PointLight::new(color, position)?;
        Ok(Own(move |point: Point3| {
            let light = source.illumination(point)?;
            let share = share((-light.direction).angle(direction), inner, outer);
            (share > 0.0).then(|| Illumination {
                color: light.color * share,
                ..light
            })
        }))
    });
}

fn smooth(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the direction to the lamp, not turned round",
        says: "light at 0.0000 radians of a spot from 0.40 to 1.20, direction [0.000, -1.000, 0.000], colour [1.0, 1.0, 1.0]: expected (1, 1, 1), got none",
        check: |c| {
            check(c, |color, at, direction, inner, outer| {
                SoftSpot::new(color, at, -direction, inner, outer)
            });
        },
    },
    Wrong {
        mistake: "not held between 0 and 1",
        says: "light at 0.0000 radians of a spot from 0.40 to 1.20, direction [0.000, -1.000, 0.000], colour [1.0, 1.0, 1.0]: expected (1, 1, 1), got none",
        check: |c| {
            share(c, |angle, inner, outer| {
                smooth((outer - angle) / (outer - inner))
            });
        },
    },
    Wrong {
        mistake: "held below 1 only, which makes light behind the rim",
        says: "light at 1.2001 radians of a spot from 0.40 to 1.20",
        check: |c| {
            share(c, |angle, inner, outer| {
                smooth(((outer - angle) / (outer - inner)).min(1.0))
            });
        },
    },
    Wrong {
        mistake: "a straight line",
        says: "light at 0.6000 radians of a spot from 0.40 to 1.20, direction [0.000, -1.000, 0.000], colour [1.0, 1.0, 1.0]: expected (0.84375, 0.84375, 0.84375), got (0.75",
        check: |c| {
            share(c, |angle, inner, outer| {
                ((outer - angle) / (outer - inner)).clamp(0.0, 1.0)
            });
        },
    },
    Wrong {
        mistake: "cosines instead of angles",
        says: "light at 0.6000 radians of a spot from 0.40 to 1.20",
        check: |c| {
            share(c, |angle, inner, outer| {
                let [cos, full, gone] = [angle, inner, outer].map(libm::cos);
                smooth(((cos - gone) / (full - gone)).clamp(0.0, 1.0))
            });
        },
    },
    Wrong {
        mistake: "fading inwards",
        says: "light at 0.0000 radians of a spot from 0.40 to 1.20, direction [0.000, -1.000, 0.000], colour [1.0, 1.0, 1.0]: expected (1, 1, 1), got none",
        check: |c| {
            share(c, |angle, inner, outer| {
                smooth(((angle - inner) / (outer - inner)).clamp(0.0, 1.0))
            });
        },
    },
    Wrong {
        mistake: "fading from the middle on",
        says: "light at 0.3999 radians of a spot from 0.40 to 1.20",
        check: |c| {
            share(c, |angle, _, outer| {
                smooth(((outer - angle) / outer).clamp(0.0, 1.0))
            });
        },
    },
    Wrong {
        mistake: "full up to the outer angle",
        says: "light at 0.6000 radians of a spot from 0.40 to 1.20",
        check: |c| share(c, |angle, _, outer| f64::from(u8::from(angle < outer))),
    },
    Wrong {
        mistake: "the angles of one spot",
        says: " radians of a spot from",
        check: |c| {
            check(c, |color, at, direction, _, _| {
                SoftSpot::new(color, at, direction, 0.4, 1.2)
            });
        },
    },
    Wrong {
        mistake: "always downwards",
        says: " radians of a spot from",
        check: |c| {
            check(c, |color, at, _, inner, outer| {
                SoftSpot::new(color, at, Vector3::new(0.0, -1.0, 0.0), inner, outer)
            });
        },
    },
];
