//! Stiff and extreme cases of rays and shapes. Single rays with an exact answer are cases of the corpus; the
//! exact values of the others follow from closed forms.

mod axis_aligned_box;
mod coincident;
mod leaks;
mod plane;
mod precision;
mod sphere;
mod triangle;

use common::{ArgumentError, Color, Transfer};
use corpus::Row;
use measure::Effort;
use measure::extremes::{Case, Fails, Flag, Holds, Id, Number, Outcome, Protocol, Without, tried};

use crate::line::Line;
use crate::support::first;
use crate::{protocol, rows};
use a04_intersections::Geometry;

pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = [
        rows::cases(&["sphere", "plane", "box", "triangle"], of_corpus),
        sphere::cases(effort),
        axis_aligned_box::cases(),
        triangle::cases(),
        bytes(),
        plane::cases(effort),
        leaks::cases(effort),
        coincident::cases(effort),
        precision::cases(effort),
    ]
    .concat();
    cases.sort_by_key(|case| case.id);
    cases
}

const EPSILON: f64 = f64::EPSILON;

/// The `t` of the nearest hit as an outcome, or the error of a constructor.
fn meeting<G: Geometry>(shape: Result<G, ArgumentError>, line: Line) -> Outcome {
    tried(|| Ok(first(&shape?, &line.unit_ray()?)))
}

/// A case of the corpus, of a shape of this stage.
fn of_corpus(row: &Row) -> Case {
    rows::described(&row.case.question.shape)
        .map(|shapes| rows::met(shapes, row))
        .unwrap_or_default()
}

/// A channel as a byte.
fn byte(id: Id, channel: f64, exact: f64, protocol: Protocol) -> Case {
    let [ours, ..] = Transfer::Linear.bytes(Color::gray(channel));
    let theirs = protocol::byte(channel);
    Case {
        id,
        what: format!("a channel of {channel} as a byte"),
        exact: Number(exact),
        condition: Without("a byte is a whole number"),
        protocol,
        ..Case::of(f64::from(ours), f64::from(theirs))
    }
}

fn bytes() -> Vec<Case> {
    vec![
        byte("H01", 1.5, 255.0, Fails),
        byte("H02", -0.5, 0.0, Fails),
        byte("H03", f64::NAN, 0.0, Holds),
        byte("H04", f64::INFINITY, 255.0, Fails),
        byte("H05", 0.5, 128.0, Fails),
        byte("H06", 0.999_999, 255.0, Fails),
        byte("H07", 0.5 / 255.0, 1.0, Fails),
        Case {
            id: "H08",
            what: "a channel of NaN is black, but not unnoticed: is the colour finite?".into(),
            exact: Flag(false),
            ours: Color::gray(f64::NAN).is_finite().into(),
            ..Case::default()
        },
    ]
}
