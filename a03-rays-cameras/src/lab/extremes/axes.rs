//! The axes of a camera: gaze and up vector that are nearly parallel, or very
//! long or short.

use a02_math::{Direction, Point3, Vector3};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{AHEAD, UP, triple};
use crate::{Basis, protocol};

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let angles = [u.dot(v), v.dot(w), w.dot(u)];
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    let worst = |defects: [f64; 3]| defects.map(f64::abs).into_iter().fold(0.0, f64::max);
    worst(angles).max(worst(lengths))
}

pub fn cases() -> Vec<Case> {
    let row = |id, what: &str, exact: Outcome, bound, says, gaze, up| {
        let basis = Basis::new(Point3::ORIGIN, gaze, up);
        let [u, ..] = protocol::axes(gaze, up);
        Case::new(id, what, exact, bound, basis.map(|basis| triple(basis.u)))
            .protocol(says, triple(u))
    };
    let refused = |id, what, gaze, up| {
        let (refused, fails) = (Outcome::Refused, Protocol::Fails);
        row(id, what, refused, Bound::Equal, fails, gaze, up)
    };
    let right = |id, what, gaze, up| {
        let right = [1.0, 0.0, 0.0].into();
        row(id, what, right, Bound::Equal, Protocol::Fails, gaze, up)
    };
    let slanted = Vector3::new(1.0, 2.0, 3.0);
    let nearly_slanted = Vector3::new(1.0 + 1e-11, 2.0, 3.0);
    vec![
        refused("E12", "axes, gaze = up = (0, 1, 0)", UP, UP),
        refused(
            "E13",
            "axes, gaze = 2 up, up = (1, 2, 3)",
            slanted * 2.0,
            slanted,
        ),
        row(
            "E14",
            "u of gaze (1, 2, 3) and up (1+1e-11, 2, 3)",
            [0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1].into(),
            Bound::Absolute(1e-3),
            Protocol::Holds,
            slanted,
            nearly_slanted,
        ),
        Case::new(
            "E31",
            "axes of E14: how far from a right angle, gaze and up being 2.6e-12 apart",
            0.0,
            Bound::Absolute(4.0 * f64::EPSILON / 2.6e-12),
            Basis::new(Point3::ORIGIN, slanted, nearly_slanted).map(defect),
        ),
        refused("E15", "axes, gaze = 0", Vector3::default(), UP),
        right("E16", "u of gaze (0, 0, -1e200)", AHEAD * 1e200, UP),
        right("E17", "u of up (0, 1e-170, 0)", AHEAD, UP * 1e-170),
    ]
}
