//! The axes of a camera: gaze and up vector that are nearly parallel, or very
//! long or short.

use a02_math::{Direction, Point3, Vector3};
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Id, Outcome, Refused};

use super::{AHEAD, UP};
use crate::{Basis, protocol};

/// The axis u of a camera. The protocol does not check gaze and up vector.
fn u(id: Id, what: &str, gaze: Vector3, up: Vector3, exact: impl Into<Outcome>) -> Case {
    let ours = Basis::new(Point3::ORIGIN, gaze, up).map(|basis| basis.u);
    let [theirs, ..] = protocol::axes(gaze, up);
    Case::new(id, what, exact, Equal, ours).protocol(Fails, theirs)
}

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let angles = [u.dot(v), v.dot(w), w.dot(u)].into_iter();
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    angles.chain(lengths).map(f64::abs).fold(0.0, f64::max)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let right = [1.0, 0.0, 0.0];
    let (slanted, near) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.0 + 1e-11, 2.0, 3.0));
    let basis = Basis::new(Point3::ORIGIN, slanted, near);
    vec![
        u("E12", "axes, gaze = up = (0, 1, 0)", UP, UP, Refused),
        u("E13", "axes, gaze = 2 up, up = (1, 2, 3)", slanted * 2.0, slanted, Refused),
        Case::new("E14", "u of gaze (1, 2, 3) and up (1+1e-11, 2, 3)",
            [0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1], Absolute(1e-3),
            basis.clone().map(|basis| basis.u)).protocol(Holds, protocol::axes(slanted, near)[0]),
        Case::new("E31", "axes of E14: how far from a right angle, gaze and up being 2.6e-12 apart",
            0.0, Absolute(4.0 * f64::EPSILON / 2.6e-12), basis.map(defect)),
        u("E15", "axes, gaze = 0", Vector3::default(), UP, Refused),
        u("E16", "u of gaze (0, 0, -1e200)", AHEAD * 1e200, UP, right),
        u("E17", "u of up (0, 1e-170, 0)", AHEAD, UP * 1e-170, right),
    ]
}
