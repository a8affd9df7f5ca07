//! `rows`: rows of `cases.toml` that are a ray and a shape, for the laboratories of stages 4, 6 and 7.

use a02_math::Direction;
use corpus::{Question, Shape};
use measure::extremes::{Case, Number, Outcome, Refused, Row};

use crate::compared_shape::{BOX, ComparedShape, PLANE, SPHERE, TRIANGLE};
use crate::line::{Line, line};
use crate::support::{first, vector};

/// A shape, or several triangles, as a compared shape and the numbers of each.
pub type Described = (&'static ComparedShape, Vec<Vec<f64>>);

/// A shape of this stage; `None` for a disc or a tube.
pub fn described(shape: &Shape) -> Option<Described> {
    match shape {
        Shape::Plane { point, normal } => Some((&PLANE, vec![[*point, *normal].concat()])),
        Shape::Sphere { center, radius } => {
            Some((&SPHERE, vec![[&center[..], &[*radius]].concat()]))
        }
        Shape::Box { low, high } => Some((&BOX, vec![[*low, *high].concat()])),
        Shape::Triangles(all) => {
            let numbers = all.iter().map(|corners| corners.concat());
            Some((&TRIANGLE, numbers.collect()))
        }
        Shape::Disc { .. } | Shape::Tube { .. } => None,
    }
}

/// The ray of a question, with a direction of any length.
pub fn line_of(question: &Question) -> Line {
    line(question.origin, question.direction)
}

/// The distance of the nearest hit, by the lesson's formula and the protocol's.
pub fn met((compared, shapes): Described, row: &Row, question: &Question) -> Case {
    let line = line_of(question);
    let mut nearest: Option<Case> = None;
    for numbers in &shapes {
        let met = match row.asks.as_str() {
            "distance" => compared.met(numbers, line),
            "as-given" => met_as_given(compared, numbers, line),
            "unchecked" => met_unchecked(compared, numbers, line),
            _ => Row::unknown(),
        };
        nearest = Some(match nearest {
            Some(other) => Case::of(
                nearer(other.ours, met.ours),
                nearer(
                    other.theirs.unwrap_or_default(),
                    met.theirs.unwrap_or_default(),
                ),
            ),
            None => met,
        });
    }
    nearest.unwrap_or_default()
}

/// Where the protocol's formula gets a direction of another length, in units of which its `t` is.
fn met_as_given(compared: &ComparedShape, numbers: &[f64], line: Line) -> Case {
    let Ok(ray) = line.unit_ray() else {
        return Case::of(Refused, (compared.protocol)(numbers, &line.raw_ray()));
    };
    let length = ray.direction().dot(vector(line.direction));
    let theirs = (compared.protocol)(numbers, &line.raw_ray());
    Case::of(compared.lesson(numbers, &ray), theirs.map(|t| t * length))
}

/// A ray that no scene contains, past its constructor.
fn met_unchecked(compared: &ComparedShape, numbers: &[f64], line: Line) -> Case {
    let ray = line.raw_ray();
    let ours = (compared.make)(numbers).map(|shape| first(&*shape, &ray));
    Case::of(ours.ok_or(Refused), (compared.protocol)(numbers, &ray))
}

/// The lesser of two distances.
fn nearer(one: Outcome, other: Outcome) -> Outcome {
    match (one, other) {
        (Number(a), Number(b)) => Number(a.min(b)),
        (Number(_), _) => one,
        _ => other,
    }
}
