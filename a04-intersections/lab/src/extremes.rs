//! Stiff and extreme cases of rays and shapes: the rows of `cases.toml`, and here counts over many rays and what
//! has a formula of its own.

mod coincident;
mod leaks;
mod plane;
mod precision;
mod sphere;
mod triangle;

use common::{ArgumentError, Color, Transfer};
use measure::Effort;
use measure::extremes::{Case, Flag, Outcome, Row, tried};

use crate::line::Line;
use crate::support::first;
use crate::{protocol, rows};
use a04_intersections::Geometry;

/// The rows that are numbers in, a number out.
const ROWS: &str = include_str!("../cases.toml");

pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = [
        measure::extremes::rows(ROWS, computed),
        sphere::cases(),
        triangle::cases(),
        vec![no_number()],
        plane::cases(effort),
        leaks::cases(effort),
        coincident::cases(effort),
        precision::cases(effort),
    ]
    .concat();
    cases.sort_by(|a, b| a.id.cmp(&b.id));
    cases
}

const EPSILON: f64 = f64::EPSILON;

/// The `t` of the nearest hit as an outcome, or the error of a constructor.
fn nearest_hit<G: Geometry>(shape: Result<G, ArgumentError>, line: Line) -> Outcome {
    tried(|| Ok(first(&shape?, &line.unit_ray()?)))
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    if let Some(question) = &row.ray {
        let shapes = rows::described(&question.shape);
        return shapes.map_or_else(Row::unknown, |shapes| rows::met(shapes, row, question));
    }
    match row.asks.as_str() {
        "byte" => {
            let [ours, ..] = Transfer::Linear.bytes(Color::gray(row.number(0)));
            Case::of(f64::from(ours), f64::from(protocol::byte(row.number(0))))
        }
        _ => Row::unknown(),
    }
}

fn no_number() -> Case {
    Case {
        id: "H08".into(),
        what: "a channel of NaN is black, but not unnoticed: is the colour finite?".into(),
        exact: Flag(false),
        ours: Color::gray(f64::NAN).is_finite().into(),
        ..Case::default()
    }
}
