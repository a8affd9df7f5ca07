//! The formula of Möller and Trumbore in doubles.

use a04_lab::formula::triangle::{Meeting, moeller_trumbore};
use a04_lab::line::Line;
use corpus::{CASES, Found, Question, Shape};

use crate::{Adapter, nearest, within};

pub const ADAPTER: Adapter = Adapter {
    name: "moeller-trumbore",
    title: "Möller-Trumbore in doubles",
    cases: CASES,
    ask,
};

fn ask(question: &Question) -> Option<Found> {
    let Shape::Triangles(all) = &question.shape else {
        return None;
    };
    if !question.under.is_empty() {
        return None;
    }
    let line = Line {
        origin: question.origin,
        direction: question.direction,
    };
    Some(nearest(all.iter().map(|corners| {
        let Meeting { t, beta, gamma } = moeller_trumbore(corners, &line);
        // The numbers of a ray along the plane are infinite or no numbers.
        let is_inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
        within(question, is_inside.then_some(t).filter(|t| !t.is_nan()))
    })))
}
