//! Problems of this stage from harmless to extreme.

mod direction;
mod far_ball;
mod needle;
mod tangent;

pub use direction::DIRECTION;
pub use far_ball::FAR_BALL;
pub use needle::NEEDLE;
pub use tangent::TANGENT;

use a03_rays_cameras::Ray;
use measure::exact::DoubleDouble;
use measure::extremes::AgainstProtocol;
use measure::sweep::{Exercise, Point};

use crate::compared_shape::{ComparedShape, SPHERE};
use crate::formula::sphere::terms;
use crate::line::Line;
use crate::number::{Triple, difference};

/// The exercise of a shape.
const fn exercise(name: &'static str) -> Exercise {
    Exercise { name, part: "t" }
}

/// The `t` of the first hit of a ray, by the lesson and by the protocol.
fn against_protocol(
    compared: &ComparedShape,
    shape: &[f64],
    ray: &Ray,
) -> AgainstProtocol<Option<f64>> {
    AgainstProtocol {
        ours: compared.lesson(shape, ray),
        theirs: (compared.protocol)(shape, ray),
    }
}

/// The sphere around the origin.
const UNIT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

/// The first hit of a line whose direction has the length 1.
fn hit_of_unit(line: Line) -> Point {
    let found = against_protocol(&SPHERE, &UNIT, &line.raw_ray());
    ahead(Point::of(
        &[&UNIT[..], &line.origin, &line.direction].concat(),
        near_root,
        found,
    ))
}

/// The point with the numbers that an exercise of a shape takes: those of shape and line, and an interval.
fn ahead(mut point: Point) -> Point {
    point.given.extend([0.0, f64::INFINITY]);
    point
}

/// The near root of a sphere's centre and radius, and a line's origin and direction.
fn near_root(x: &[DoubleDouble]) -> DoubleDouble {
    let triple = |at: usize| -> Triple<DoubleDouble> { [x[at], x[at + 1], x[at + 2]] };
    let from_center = difference(&triple(4), &triple(0));
    terms(&from_center, x[3], &triple(7)).plain_roots()[0]
}
