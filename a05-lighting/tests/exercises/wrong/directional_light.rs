//! Wrong solutions.

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::directional_light;

/// A light of this colour, direction and distance.
#[derive(Debug)]
struct Sun(Color, Vector3, f64);

impl Light for Sun {
    fn illumination(&self, _: Point3) -> Option<Illumination> {
        let Self(color, direction, distance) = *self;
        Some(Illumination {
            color,
            direction,
            distance,
        })
    }
}

fn check(check: &mut Check, sun: fn(Color, Vector3) -> Sun) {
    directional_light::check(check, |color, direction| Ok(sun(color, direction)));
}

fn unit(v: Vector3) -> Vector3 {
    v.normalized().unwrap_or_default()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the direction in which the light travels",
        says: "the direction to the light",
        check: |c| check(c, |color, d| Sun(color, unit(d), f64::INFINITY)),
    },
    Wrong {
        mistake: "the direction is not of length 1",
        says: "the direction to the light",
        check: |c| check(c, |color, d| Sun(color, -d, f64::INFINITY)),
    },
    Wrong {
        mistake: "a distance, beyond which no object would cast a shadow",
        says: "the distance",
        check: |c| check(c, |color, d| Sun(color, -unit(d), 1.0)),
    },
    Wrong {
        mistake: "the distance 0",
        says: "the distance",
        check: |c| check(c, |color, d| Sun(color, -unit(d), 0.0)),
    },
];
