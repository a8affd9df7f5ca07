//! The lesson's formula of the sphere and that of Möller and Trumbore, in single precision.

use a04_lab::formula::sphere::{Shot, stable};
use a04_lab::formula::triangle::{Meeting, moeller_trumbore};
use a04_lab::line::Line;
use corpus::{Found, Question, SINGLE_CASES, Shape};

use crate::{Adapter, nearest, within};

pub const ADAPTER: Adapter = Adapter {
    name: "single-precision",
    title: "the lesson's sphere and Möller-Trumbore in single precision",
    cases: SINGLE_CASES,
    ask,
};

/// Exact: all numbers of these cases have single precision.
fn three(numbers: [f64; 3]) -> [f32; 3] {
    numbers.map(|number| number as f32)
}

fn ask(question: &Question) -> Option<Found> {
    if !question.under.is_empty() {
        return None;
    }
    let line = Line {
        origin: three(question.origin),
        direction: three(question.direction),
    };
    match &question.shape {
        // This formula looks from 0 on.
        Shape::Sphere { center, radius } if question.within[0] == 0.0 => {
            let shot = Shot {
                center: three(*center),
                radius: *radius as f32,
                line,
            };
            Some(within(question, stable(&shot).map(f64::from)))
        }
        Shape::Triangles(all) => Some(nearest(all.iter().map(|corners| {
            let Meeting { t, beta, gamma } = moeller_trumbore(&corners.map(three), &line);
            let is_inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
            let t = is_inside.then_some(f64::from(t));
            within(question, t.filter(|t| !t.is_nan()))
        }))),
        _ => None,
    }
}
