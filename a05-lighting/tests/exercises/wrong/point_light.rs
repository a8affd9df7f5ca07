//! Wrong solutions.

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::point_light;

/// A light that follows from its colour and the way from the point to it.
#[derive(Debug)]
struct Lamp(Color, Point3, fn(Color, Vector3) -> Option<Illumination>);

impl Light for Lamp {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        (self.2)(self.0, self.1 - point)
    }
}

fn check(check: &mut Check, light: fn(Color, Vector3) -> Option<Illumination>) {
    point_light::check(check, |color, position| Ok(Lamp(color, position, light)));
}

fn right(color: Color, way: Vector3) -> Option<Illumination> {
    let (direction, distance) = (way.normalized()?, way.magnitude());
    Some(Illumination {
        color,
        direction,
        distance,
    })
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "from the light to the point",
        says: "the direction to the light, at a point",
        check: |c| check(c, |color, way| right(color, -way)),
    },
    Wrong {
        mistake: "the direction is not of length 1",
        says: "the direction to the light, at a point",
        check: |c| {
            check(c, |color, way| {
                Some(Illumination {
                    direction: way,
                    ..right(color, way)?
                })
            });
        },
    },
    Wrong {
        mistake: "the square of the distance",
        says: "the distance, at a point",
        check: |c| {
            check(c, |color, way| {
                let right = right(color, way)?;
                Some(Illumination {
                    distance: right.distance * right.distance,
                    ..right
                })
            });
        },
    },
    Wrong {
        mistake: "a direction of zeros in the light itself",
        says: "whether light arrives, in the light itself",
        check: |c| {
            check(c, |color, way| {
                right(color, way).or(Some(Illumination {
                    color,
                    ..Illumination::default()
                }))
            });
        },
    },
    Wrong {
        mistake: "weaker with distance",
        says: "the colour, at a point",
        check: |c| {
            check(c, |color, way| {
                let right = right(color, way)?;
                Some(Illumination {
                    color: color * (1.0 / right.distance),
                    ..right
                })
            });
        },
    },
];
