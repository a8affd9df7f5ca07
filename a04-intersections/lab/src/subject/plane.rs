//! The plane: one of its points, and its normal.

use a02_math::arrays::{array, vector};
use a03_rays_cameras::Ray;

use super::{ExactHit, Subject, triple, unit_normal};
use crate::certified::decide;
use crate::line::Line;
use crate::support::{Triple, point};
use crate::{condition, exact, protocol};
use a04_intersections::{Geometry, Plane};

pub const PLANE: Subject = Subject {
    name: "plane",
    written: "Plane::new(Point3::new(#, #, #), Normal3::new(#, #, #))",
    make,
    aim,
    through,
    decide,
    exact,
    protocol,
};

fn plane(numbers: &[f64]) -> Option<Plane> {
    let normal = vector(triple(&numbers[3..])).as_normal();
    Plane::new(point(triple(numbers)), normal).ok()
}

fn make(numbers: &[f64]) -> Option<Box<dyn Geometry>> {
    Some(Box::new(plane(numbers)?))
}

fn aim(numbers: &[f64], aim: Triple) -> Triple {
    [0, 1, 2].map(|axis| numbers[axis] + aim[axis])
}

/// The point of the plane lies there.
fn through(numbers: &mut [f64], point: Triple) {
    numbers[..3].copy_from_slice(&point);
}

fn exact(numbers: &[f64], line: &Line) -> Option<ExactHit> {
    let point = triple(numbers);
    // The lesson's rounded normal is the given one.
    let normal = array(plane(numbers)?.normal());
    let t = exact::plane(&point, &normal, line);
    let condition = condition::of_plane(&point, normal, line, t.value());
    Some(ExactHit { t, condition })
}

fn protocol(numbers: &[f64], ray: &Ray) -> Option<f64> {
    protocol::plane(point(triple(numbers)), unit_normal(numbers), ray)
}
