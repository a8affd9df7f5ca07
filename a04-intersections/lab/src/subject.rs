//! `Subject`: a shape as some numbers, with the lesson's formula, the protocol's, and exact ones.

mod aligned_box;
mod plane;
mod sphere;
mod triangle;

use a02_math::Normal3;
use a02_math::arrays::vector;
use a03_rays_cameras::Ray;
use common::Error;
use measure::extremes::{Case, Nothing, Number, Outcome, Refused};

use crate::certified::Decide;
use crate::exact::DoubleDouble;
use crate::line::Line;
use crate::support::{Triple, first};
use a04_intersections::{Geometry, Interval};

pub use aligned_box::BOX;
pub use plane::PLANE;
pub use sphere::SPHERE;
pub use triangle::TRIANGLE;

/// A shape that some numbers describe.
pub struct Subject {
    pub name: &'static str,
    /// Its constructor in Rust, with `#` instead of each number.
    pub written: &'static str,
    /// The shape of these numbers, unless its constructor refuses them.
    pub make: fn(&[f64]) -> Option<Box<dyn Geometry>>,
    /// The point near the shape that three numbers, mostly from -1 to 1, stand for.
    pub aim: fn(&[f64], Triple) -> Triple,
    /// Changes the size or the position of a shape of these numbers, so that its border passes through a point, up
    /// to rounding.
    pub through: fn(&mut [f64], Triple),
    pub decide: Decide,
    pub exact: fn(&[f64], &Line) -> Option<ExactHit>,
    /// The `t` of the nearest hit by the protocol's formula.
    pub protocol: fn(&[f64], &Ray) -> Option<f64>,
}

/// The exact hit of a ray that hits.
#[derive(Clone, Copy, Debug)]
pub struct ExactHit {
    /// With 30 digits.
    pub t: DoubleDouble,
    /// The condition of `t`. It is infinite where the ray starts on the shape: moved by any length,
    /// the origin may lie before the shape, and its hit there is the nearest.
    pub condition: f64,
}

/// The shapes of this stage.
pub static SUBJECTS: [Subject; 4] = [SPHERE, PLANE, BOX, TRIANGLE];

/// The first three numbers.
pub fn triple(numbers: &[f64]) -> Triple {
    [numbers[0], numbers[1], numbers[2]]
}

/// The normal of a plane or disc, of length 1 where this is possible.
pub fn unit_normal(numbers: &[f64]) -> Normal3 {
    let n = vector(triple(&numbers[3..]));
    n.normalized().unwrap_or(n).as_normal()
}

impl Subject {
    /// The shape of this name.
    pub fn named<'a>(subjects: &'a [Self], name: &str) -> Result<&'a Self, Error> {
        for subject in subjects {
            if subject.name == name {
                return Ok(subject);
            }
        }
        let names: Vec<_> = subjects.iter().map(|subject| subject.name).collect();
        let names = names.join(", ");
        Err(Error::Usage(format!(
            "no shape \"{name}\" is searched here, only {names}"
        )))
    }

    /// The nearest hit of a ray by the lesson's formula and the protocol's; and the exact one by
    /// intervals and 30 digits, unless they leave it open. The row lacks its words.
    pub fn met(&self, numbers: &[f64], line: Line) -> Case {
        let theirs = (self.protocol)(numbers, &line.any_ray());
        let (Some(shape), Ok(ray)) = ((self.make)(numbers), line.unit_ray()) else {
            return Case::of(Refused, theirs);
        };
        let exact = (self.exact)(numbers, &Line::of(&ray));
        let is_hit = (self.decide)(&*shape, &ray, Interval::AHEAD);
        Case {
            condition: exact.map(|exact| exact.condition).into(),
            certified: certified(is_hit, exact),
            ..Case::of(first(&*shape, &ray), theirs)
        }
    }

    /// The `t` of the nearest hit by the lesson's formula.
    pub fn lesson(&self, numbers: &[f64], ray: &Ray) -> Option<f64> {
        first(&*(self.make)(numbers)?, ray)
    }
}

/// The `t` of a certified hit or miss.
fn certified(is_hit: Option<bool>, exact: Option<ExactHit>) -> Option<Outcome> {
    if is_hit? {
        Some(Number(exact?.t.value()))
    } else {
        Some(Nothing)
    }
}
