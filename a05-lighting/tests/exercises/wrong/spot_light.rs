//! Wrong solutions.

use a02_math::{Direction, Point3, Vector3};
use a05_lighting::{Illumination, Light, PointLight};
use testing::exercise::{Check, Wrong};

use crate::spot_light;

/// A light whose cone follows from the cosine of the point's angle and the half angle.
#[derive(Debug)]
struct Spot(PointLight, Vector3, f64, fn(f64, f64) -> bool);

impl Light for Spot {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.0.illumination(point)?;
        let cosine = (-light.direction).dot(self.1).clamp(-1.0, 1.0);
        (self.3)(cosine, self.2).then_some(light)
    }
}

fn check(check: &mut Check, is_lit: fn(f64, f64) -> bool) {
    spot_light::check(check, |color, position, direction, half_angle| {
        let axis = direction.unit("direction")?;
        Ok(Spot(
            PointLight::new(color, position)?,
            axis,
            half_angle,
            is_lit,
        ))
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the half angle taken for the whole",
        says: "whether light arrives, just inside the edge",
        check: |c| check(c, |cosine, half| libm::acos(cosine) <= half / 2.0),
    },
    Wrong {
        mistake: "the direction to the light compared with the axis",
        says: "whether light arrives, on the axis",
        check: |c| check(c, |cosine, half| libm::acos(-cosine) <= half),
    },
    Wrong {
        mistake: "the sine, which is the same before and behind",
        says: "whether light arrives, behind the light",
        check: |c| {
            check(c, |cosine, half| {
                (1.0 - cosine * cosine).sqrt() <= libm::sin(half)
            });
        },
    },
    Wrong {
        mistake: "outside of the cone",
        says: "whether light arrives, in the cone",
        check: |c| check(c, |cosine, half| cosine <= libm::cos(half)),
    },
    Wrong {
        mistake: "never behind the light",
        says: "whether light arrives",
        check: |c| check(c, |cosine, half| cosine > 0.0 && libm::acos(cosine) <= half),
    },
];
