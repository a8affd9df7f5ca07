//! Lamps that fade too little, too much, or to the wrong side.

use a02_math::{Direction, Point3};
use a05_lighting::{Illumination, Light};
use testing::exercise::{Check, Wrong};

use crate::fading_light::check;
use crate::own::Own;
use crate::solutions::fading_light::FadingLight;

/// The right lamp, but for this, given its light, its position and the point.
fn changed(c: &mut Check, light: fn(Illumination, Point3, Point3) -> Illumination) {
    check(c, |color, position| {
        let lamp = FadingLight::new(color, position)?;
        Ok(Own(move |point| {
            Some(light(lamp.illumination(point)?, position, point))
        }))
    });
}

/// The light with its colour times this.
fn times(light: Illumination, factor: f64) -> Illumination {
    Illumination {
        color: light.color * factor,
        ..light
    }
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "fading with the distance, not with its square",
        says: "colour at the distance 2 along [1.000, 0.000, 0.000] from a lamp at [3, -1, 2] with [1.0, 0.5, 0.25]: expected (0.25, 0.125, 0.0625), got (0.5, 0.25, 0.125)",
        check: |c| changed(c, |light, _, _| times(light, light.distance)),
    },
    Wrong {
        mistake: "not fading",
        says: "expected (0.25, 0.125, 0.0625), got (1, 0.5, 0.25)",
        check: |c| {
            changed(c, |light, _, _| {
                times(light, light.distance * light.distance)
            });
        },
    },
    Wrong {
        mistake: "spread over the whole sphere, 4 π d²",
        says: "expected (0.25, 0.125, 0.0625), got (0.0198",
        check: |c| {
            changed(c, |light, _, _| times(light, 0.25 / std::f64::consts::PI));
        },
    },
    Wrong {
        mistake: "never brighter than at the distance 1",
        says: "colour at the distance 0.5 along [1.000, 0.000, 0.000] from a lamp at [3, -1, 2] with [1.0, 0.5, 0.25]: expected (4, 2, 1), got (1, 0.5, 0.25)",
        check: |c| {
            changed(c, |light, _, _| {
                times(light, (light.distance * light.distance).min(1.0))
            });
        },
    },
    Wrong {
        mistake: "divided by d² + 1, so that it stays finite",
        says: "expected (0.25, 0.125, 0.0625), got (0.2,",
        check: |c| {
            changed(c, |light, _, _| {
                let squared = light.distance * light.distance;
                times(light, squared / (squared + 1.0))
            });
        },
    },
    Wrong {
        mistake: "a direction away from the lamp",
        says: "direction at the distance 2 along [1.000, 0.000, 0.000] from a lamp at [3, -1, 2] with [1.0, 0.5, 0.25]: expected (1, 0, 0), got (-1, -0, -0)",
        check: |c| {
            changed(c, |light, _, _| Illumination {
                direction: -light.direction,
                ..light
            });
        },
    },
    Wrong {
        mistake: "a direction that is not made unit",
        says: "direction at the distance 2 along [1.000, 0.000, 0.000] from a lamp at [3, -1, 2] with [1.0, 0.5, 0.25]: expected (1, 0, 0), got (2, 0, 0)",
        check: |c| {
            changed(c, |light, position, point| Illumination {
                direction: position - point,
                ..light
            });
        },
    },
    Wrong {
        mistake: "the square for the distance",
        says: "distance at the distance 2 along [1.000, 0.000, 0.000] from a lamp at [3, -1, 2] with [1.0, 0.5, 0.25]: expected 2, got 4",
        check: |c| {
            changed(c, |light, position, point| {
                let way = position - point;
                Illumination {
                    distance: way.dot(way),
                    ..light
                }
            });
        },
    },
    Wrong {
        mistake: "infinite light in the lamp",
        says: "in the lamp there is no light: expected yes, got no",
        check: |c| {
            check(c, |color, position| {
                let lamp = FadingLight::new(color, position)?;
                Ok(Own(move |point| {
                    lamp.illumination(point)
                        .or_else(|| Some(Illumination::default()))
                }))
            });
        },
    },
];
