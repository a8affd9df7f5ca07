//! The triangle: its corners.

use a03_rays_cameras::Ray;

use super::{ExactHit, Subject, triple};
use crate::certified::decide;
use crate::line::Line;
use crate::support::{Triple, point};
use crate::{condition, exact, protocol};
use a04_intersections::{Geometry, Triangle};

pub const TRIANGLE: Subject = Subject {
    name: "triangle",
    written: "Triangle::new(Point3::new(#, #, #), Point3::new(#, #, #), Point3::new(#, #, #))",
    make,
    aim,
    through,
    decide,
    exact,
    protocol,
};

fn corners(numbers: &[f64]) -> [Triple; 3] {
    [0, 3, 6].map(|corner| triple(&numbers[corner..]))
}

fn make(numbers: &[f64]) -> Option<Box<dyn Geometry>> {
    let [a, b, c] = corners(numbers).map(point);
    Some(Box::new(Triangle::new(a, b, c).ok()?))
}

fn aim(numbers: &[f64], aim: Triple) -> Triple {
    let [a, b, c] = corners(numbers);
    [0, 1, 2].map(|axis| {
        let (along_b, along_c) = (b[axis] - a[axis], c[axis] - a[axis]);
        a[axis] + along_b * aim[0] + along_c * aim[1]
    })
}

/// The second corner lies there.
fn through(numbers: &mut [f64], point: Triple) {
    numbers[3..6].copy_from_slice(&point);
}

#[expect(
    clippy::unnecessary_wraps,
    reason = "the type of every shape's function"
)]
fn exact(numbers: &[f64], line: &Line) -> Option<ExactHit> {
    let corners = corners(numbers);
    let meeting = exact::triangle(&corners, line);
    let t = meeting.t;
    let (beta, gamma) = (meeting.beta.value(), meeting.gamma.value());
    let condition = condition::of_triangle(&corners, beta, gamma, line, t.value());
    Some(ExactHit { t, condition })
}

fn protocol(numbers: &[f64], ray: &Ray) -> Option<f64> {
    protocol::triangle(&corners(numbers).map(point), ray)
}
