//! Boxes by naive slabs, and with corners in the wrong order. Rays along faces and edges, and with zeros in the
//! direction, are rows of `cases.toml`.
//!
//! There the protocol's formula compares all coordinates of the computed point; a case with the same number
//! and an s shows naive slabs instead.

use corpus::Shape;
use measure::extremes::{Absolute, Case, Fails, Holds, Known, Number, Row, rows};

use crate::aimed_box::slabs;
use crate::line::{Line, line};
use crate::protocol::{Compared, axis_aligned_box};
use crate::rows::line_of;
use crate::subject::BOX;
use crate::support::{Triple, first, point};
use a04_intersections::AxisAlignedBox;

/// Two opposite corners of the unit box.
const UNIT: [Triple; 2] = [[0.0; 3], [1.0; 3]];

/// The rows for which naive slabs are wrong.
const WRONG_BY_SLABS: [&str; 11] = [
    "C02", "C03", "C04", "C05", "C06", "C12", "C14", "C16", "C17", "C18", "C20",
];

pub fn cases() -> Vec<Case> {
    let mut cases = vec![corners_in_the_wrong_order(), beside_the_face()];
    for case in rows(super::ROWS, by_slabs) {
        if WRONG_BY_SLABS.contains(&case.id.as_str()) {
            let subject = case.what.split(':').next().unwrap_or_default();
            cases.push(Case {
                id: format!("{}s", case.id),
                what: format!("{subject}: naive slabs"),
                protocol: Fails,
                ..case
            });
        }
    }
    cases
}

/// A row about a box, with naive slabs instead of the protocol's formula.
fn by_slabs(row: &Row) -> Case {
    let Some(question) = &row.ray else {
        return Case::default();
    };
    let Shape::Box { low, high } = question.shape else {
        return Case::default();
    };
    let line = line_of(question);
    Case {
        theirs: Some(slabs(point(low), point(high), &line.any_ray()).into()),
        ..BOX.met(&[low, high].concat(), line)
    }
}

/// The rows have the lower corner first.
fn corners_in_the_wrong_order() -> Case {
    let [lbf, run] = UNIT;
    let line = line([0.5, 0.5, 5.0], [0.0, 0.0, -1.0]);
    let theirs = axis_aligned_box(point(run), point(lbf), &line.any_ray(), Compared::Three);
    Case {
        id: "C10".into(),
        what: "corners in the wrong order".into(),
        exact: Number(4.0),
        // Of the eye's height 5, the face's 1 and the direction.
        condition: Known(2.5),
        theirs: Some(theirs.into()),
        protocol: Fails,
        ..BOX.met(&[run, lbf].concat(), line)
    }
}

/// The line along -z within the plane of the left face, but for a slope to its side.
fn barely(slope: f64) -> Line {
    line([0.0, 0.5, 5.0], [slope, 0.0, -1.0])
}

/// How far outside of the left face a hit is, of a ray that slopes outwards by almost nothing.
fn beside_the_face() -> Case {
    let ray = barely(-1e-310).any_ray();
    let [lbf, run] = UNIT.map(point);
    let outside = |t: Option<f64>| t.map_or(0.0, |t| -ray.at(t).x());
    let ours = AxisAlignedBox::new(lbf, run).map(|unit| outside(first(&unit, &ray)));
    let theirs = outside(axis_aligned_box(lbf, run, &ray, Compared::Three));
    Case {
        id: "C15".into(),
        what: "the ray of C14, but outwards, by 4e-310: how far outside the hit is".into(),
        exact: Number(0.0),
        // Both distances may be rounded by 3 u of their 4.
        bound: Absolute(12.0 * f64::EPSILON),
        protocol: Holds,
        ..Case::of(ours, theirs)
    }
}
