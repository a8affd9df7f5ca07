//! The sphere: its centre and its radius.

use a03_rays_cameras::Ray;

use super::{ExactHit, Subject, triple};
use crate::certified::decide;
use crate::formula::sphere::Shot;
use crate::line::Line;
use crate::support::{Triple, point};
use crate::{condition, exact, protocol};
use a04_intersections::{Geometry, Sphere};

pub const SPHERE: Subject = Subject {
    name: "sphere",
    written: "Sphere::new(Point3::new(#, #, #), #)",
    make,
    aim,
    through,
    decide,
    exact,
    protocol,
};

fn shot(numbers: &[f64], line: Line) -> Shot {
    Shot {
        center: triple(numbers),
        radius: numbers[3],
        line,
    }
}

fn make(numbers: &[f64]) -> Option<Box<dyn Geometry>> {
    let sphere = Sphere::new(point(triple(numbers)), numbers[3]).ok()?;
    Some(Box::new(sphere))
}

fn aim(numbers: &[f64], aim: Triple) -> Triple {
    let radius = numbers[3];
    [0, 1, 2].map(|axis| numbers[axis] + radius * aim[axis])
}

/// The radius is the distance.
fn through(numbers: &mut [f64], place: Triple) {
    numbers[3] = (point(place) - point(triple(numbers))).magnitude();
}

fn exact(numbers: &[f64], line: &Line) -> Option<ExactHit> {
    let shot = shot(numbers, *line);
    let roots = exact::sphere(&shot).roots?;
    let t = roots.into_iter().find(|t| t.value() > 0.0)?;
    let starts_on_it = roots.into_iter().any(|t| t.value() == 0.0);
    let condition = if starts_on_it {
        f64::INFINITY
    } else {
        condition::of_sphere(&shot.center, shot.radius, line, t.value())
    };
    Some(ExactHit { t, condition })
}

fn protocol(numbers: &[f64], ray: &Ray) -> Option<f64> {
    protocol::sphere(&shot(numbers, Line::of(ray)))
}
