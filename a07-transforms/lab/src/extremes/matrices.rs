//! Chains of transforms: matrix times inverse is the identity.

use std::f64::consts::{FRAC_PI_2, TAU};

use a02_math::arrays::array;
use a02_math::{Point3, Vector3};
use common::ArgumentError;
use glam::DMat4;
use measure::extremes::{Absolute, Case, Equal, Fails, Id, Refused, greatest, tried};

use crate::protocol::{self, Chained};
use a07_transforms::{Mat4x4, Transform};

type Step = Result<Transform, ArgumentError>;

/// A transform by our formulas and by the protocol's.
type Both = (Transform, Chained);

const START: Both = (Transform::IDENTITY, Chained::IDENTITY);

fn then((ours, theirs): Both, step: impl Fn(Transform) -> Step) -> Result<Both, ArgumentError> {
    Ok((step(ours)?, theirs.then(&step(Transform::IDENTITY)?)))
}

fn identity(id: Id, what: &str, bound: f64, both: &Result<Both, ArgumentError>) -> Case {
    let what = format!("{what}: the greatest number of |M I - 1|");
    let both = both.as_ref();
    let theirs = both.map(|(_, theirs)| greatest(off_identity(theirs.m, theirs.i)));
    let ours = both.map(|(ours, _)| defect(ours));
    Case::new(id, what, 0.0, Absolute(bound), ours).protocol(Fails, theirs)
}

fn refused(id: Id, what: &str, ours: Step) -> Case {
    Case::new(id, what, Refused, Equal, ours.map(|_| true))
}

fn origin(id: Id, what: &str, exact: [f64; 3], ours: Step) -> Case {
    let what = format!("{what}: where the origin goes");
    let ours = ours.map(|t| array(t.matrix() * Point3::ORIGIN));
    Case::new(id, what, exact, Equal, ours)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    const EPS: f64 = f64::EPSILON;
    let step = Transform::IDENTITY;
    let to = Point3::new(1.0, 2.0, 3.0);
    let moved_and_turned = || then(then(START, |t| t.translate(to))?, |t| t.rotate_y(FRAC_PI_2));
    let uneven = step.scale(1e-8, 1.0, 1e8).map(|t| defect(&t));
    let huge = step.scale(1e100, 1e100, 1e100).and_then(|t| t.scale(1e100, 1e100, 1e100));
    let down = Vector3::new(0.0, 0.0, -1.0);
    let double = step.scale(2.0, 2.0, 2.0);
    // The program exchanges the factors.
    let exchanged = tried(|| {
        let [scale, move_to] = [double.clone()?, step.translate(to)?].map(|t| t.matrix());
        Ok(array(protocol::product(scale, move_to) * Point3::ORIGIN))
    });
    let full_turn = (0..360).try_fold(step, |t, _| t.rotate_z(TAU / 360.0));
    // Two axes exchanged, which is a reflection: the determinant is -1.
    let exchange =
        [[0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    vec![
        identity("G01", "100 turns", 400.0 * EPS, &turns(100)),
        identity("G02", "1e6 turns", 4e6 * EPS, &turns(1_000_000)),
        identity("G03", "translate (1, 2, 3), rotate_y π/2", 4.0 * EPS, &moved_and_turned()),
        Case::new("G04", "scale (1e-8, 1, 1e8): the greatest number of |M I - 1|", 0.0, Absolute(2.0 * EPS), uneven),
        identity("G05", "turn, scale (1e8, 1, 1), turn", 4e8 * EPS, &stretched(1e8)),
        identity("G06", "turn, scale (1e12, 1, 1), turn", 4e12 * EPS, &stretched(1e12)),
        refused("G07", "scale 1e-103", step.scale(1e-103, 1e-103, 1e-103)),
        refused("G08", "scale 1e103", step.scale(1e103, 1e103, 1e103)),
        refused("G09", "scale (0, 1, 1), which makes flat", step.scale(0.0, 1.0, 1.0))
            .protocol(Fails, array(protocol::scaled_direction([0.0, 1.0, 1.0], down))),
        refused("G22", "scale by NaN", step.scale(1.0, f64::NAN, 1.0)),
        refused("G23", "scale by infinity", step.scale(1.0, 1.0, f64::INFINITY)),
        refused("G24", "two scales by 1e100: the square is beyond all numbers", huge),
        refused("G25", "rotate_x by infinity", step.rotate_x(f64::INFINITY)),
        origin("G26", "translate (1, 2, 3)", [1.0, 2.0, 3.0], step.translate(to))
            .protocol(Fails, step.translate(to).map(|t| array(protocol::translation_in_last_row(&t) * Point3::ORIGIN))),
        // The outer step is the scaling: the object is moved first, and the way is scaled.
        origin("G27", "scale 2, then within it translate (1, 2, 3)",
            [2.0, 4.0, 6.0], double.clone().and_then(|t| t.translate(to))).protocol(Fails, exchanged),
        Case::new("G28", "360 turns by a degree, of (1, 0, 0)", [1.0, 0.0, 0.0], Absolute(4.0 * 360.0 * EPS),
            full_turn.map(|t| array(t.matrix() * Point3::new(1.0, 0.0, 0.0)))),
        Case::new("G32", "determinant of x and y exchanged: glam's, and Sarrus' with four rows",
            -1.0, Equal, DMat4::from_cols_array_2d(&exchange).determinant())
            .protocol(Fails, protocol::determinant_by_sarrus(exchange)),
    ]
}

/// Rotations about x, y and z in turn, by angles from 1 to 1.9.
fn turns(count: u32) -> Result<Both, ArgumentError> {
    (0..count).try_fold(START, |both, i| then(both, |t| turn(t, i)))
}

/// The transform after the `i`-th of these rotations.
pub fn turn(t: Transform, i: u32) -> Step {
    let axes = [
        Transform::rotate_x,
        Transform::rotate_y,
        Transform::rotate_z,
    ];
    axes[i as usize % 3](t, 1.0 + 0.1 * f64::from(i % 10))
}

/// Two rotations, a scaling of one axis by `k`, and two more rotations: the
/// condition number of the product is `k`.
fn stretched(k: f64) -> Result<Both, ArgumentError> {
    let turned = then(START, |t| t.rotate_x(0.5)?.rotate_y(0.5))?;
    let stretched = then(turned, |t| t.scale(k, 1.0, 1.0))?;
    then(stretched, |t| t.rotate_y(0.5)?.rotate_z(0.5))
}

/// The entries of `m i - 1`, without the last row, which is exact.
pub fn off_identity(m: Mat4x4, i: Mat4x4) -> [f64; 12] {
    let rows = (m * i).rows();
    std::array::from_fn(|n| {
        let (column, row) = (n / 3, n % 3);
        rows[row][column] - if row == column { 1.0 } else { 0.0 }
    })
}

fn defect(t: &Transform) -> f64 {
    greatest(off_identity(t.matrix(), t.inverse()))
}
