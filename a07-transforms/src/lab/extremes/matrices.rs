//! Chains of transforms: matrix times inverse is the identity.

use std::f64::consts::{FRAC_PI_2, TAU};

use a02_math::{Point3, Vector3};
use common::ArgumentError;
use measure::extremes::Protocol::Fails;
use measure::extremes::{Bound, Case, Outcome};

use crate::lab::protocol::{self, Chained};
use crate::{Mat4x4, Transform};

type Step = Result<Transform, ArgumentError>;

pub fn cases() -> Vec<Case> {
    const EPS: f64 = f64::EPSILON;
    let step = Transform::IDENTITY;
    let to = Point3::new(1.0, 2.0, 3.0);
    let down = Vector3::new(0.0, 0.0, -1.0);
    let zero = [0.0, 1.0, 1.0];
    let huge = (0..2).try_fold(step, |t, _| t.scale(1e100, 1e100, 1e100));
    vec![
        identity("G01", "100 turns", 400.0 * EPS, turns(100)),
        identity("G02", "1e6 turns", 4e6 * EPS, turns(1_000_000)),
        identity(
            "G03",
            "translate (1, 2, 3), rotate_y π/2",
            4.0 * EPS,
            moved_and_turned(to),
        ),
        identity_of_scale("G04", [1e-8, 1.0, 1e8], 2.0 * EPS),
        identity(
            "G05",
            "turn, scale (1e8, 1, 1), turn",
            4e8 * EPS,
            stretched(1e8, [0.5; 4]),
        ),
        identity(
            "G06",
            "turn, scale (1e12, 1, 1), turn",
            4e12 * EPS,
            stretched(1e12, [0.5; 4]),
        ),
        refused("G07", "scale 1e-103", step.scale(1e-103, 1e-103, 1e-103)),
        refused("G08", "scale 1e103", step.scale(1e103, 1e103, 1e103)),
        refused(
            "G09",
            "scale (0, 1, 1), which makes flat",
            step.scale(0.0, 1.0, 1.0),
        )
        .protocol(Fails, triple(protocol::scaled_direction(zero, down))),
        refused("G22", "scale by NaN", step.scale(1.0, f64::NAN, 1.0)),
        refused(
            "G23",
            "scale by infinity",
            step.scale(1.0, 1.0, f64::INFINITY),
        ),
        refused(
            "G24",
            "two scales by 1e100: the square is beyond all numbers",
            huge,
        ),
        refused("G25", "rotate_x by infinity", step.rotate_x(f64::INFINITY)),
        origin(
            "G26",
            "translate (1, 2, 3)",
            [1.0, 2.0, 3.0],
            step.translate(to),
        )
        .protocol(Fails, place(protocol::translation_in_last_row(to))),
        moved_and_stretched(to),
        full_turn("G28"),
        sarrus("G32"),
    ]
}

/// A transform by our formulas and by the protocol's.
struct Both {
    ours: Transform,
    theirs: Chained,
}

impl Both {
    const IDENTITY: Self = Self {
        ours: Transform::IDENTITY,
        theirs: Chained::IDENTITY,
    };

    fn then(self, step: impl Fn(Transform) -> Step) -> Result<Self, ArgumentError> {
        Ok(Self {
            ours: step(self.ours)?,
            theirs: self.theirs.then(&step(Transform::IDENTITY)?),
        })
    }
}

/// Rotations about x, y and z in turn, by angles from 1 to 1.9.
fn turns(count: u32) -> Result<Both, ArgumentError> {
    (0..count).try_fold(Both::IDENTITY, |both, i| both.then(|t| turn(t, i)))
}

/// The transform after the `i`-th of these rotations.
pub fn turn(t: Transform, i: u32) -> Step {
    let angle = 1.0 + 0.1 * f64::from(i % 10);
    match i % 3 {
        0 => t.rotate_x(angle),
        1 => t.rotate_y(angle),
        _ => t.rotate_z(angle),
    }
}

/// Two rotations, a scaling of one axis by `k`, and two more rotations: the
/// condition number of the product is `k`.
fn stretched(k: f64, [a, b, c, d]: [f64; 4]) -> Result<Both, ArgumentError> {
    Both::IDENTITY
        .then(|t| t.rotate_x(a)?.rotate_y(b))?
        .then(|t| t.scale(k, 1.0, 1.0))?
        .then(|t| t.rotate_y(c)?.rotate_z(d))
}

fn moved_and_turned(to: Point3) -> Result<Both, ArgumentError> {
    Both::IDENTITY
        .then(|t| t.translate(to))?
        .then(|t| t.rotate_y(FRAC_PI_2))
}

/// The entries of `m i - 1`, without the last row, which is exact.
pub fn off_identity(m: Mat4x4, i: Mat4x4) -> [f64; 12] {
    let product = m * i;
    let axis = |x, y, z| {
        let unit = Vector3::new(x, y, z);
        triple(product * unit - unit)
    };
    let [x, y, z] = [
        axis(1.0, 0.0, 0.0),
        axis(0.0, 1.0, 0.0),
        axis(0.0, 0.0, 1.0),
    ];
    let [a, b, c] = place(product);
    [
        x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2], a, b, c,
    ]
}

/// The greatest magnitude in `m i - 1`; NaN stays NaN.
fn defect(m: Mat4x4, i: Mat4x4) -> f64 {
    let numbers = off_identity(m, i).map(f64::abs).into_iter();
    numbers.fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
}

fn triple(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}

/// The image of the origin under a matrix.
fn place(m: Mat4x4) -> [f64; 3] {
    (m * Point3::ORIGIN).to_glam().to_array()
}

fn identity(id: &'static str, what: &str, bound: f64, both: Result<Both, ArgumentError>) -> Case {
    let what = format!("{what}: the greatest number of |M I - 1|");
    let defects = both.map(|Both { ours, theirs }| {
        let ours = defect(ours.matrix(), ours.inverse());
        [ours, defect(theirs.m, theirs.i)]
    });
    let [ours, theirs] = [0, 1].map(|of| defects.clone().map(|defects| defects[of]));
    Case::new(id, what, 0.0, Bound::Absolute(bound), ours).protocol(Fails, theirs)
}

fn identity_of_scale(id: &'static str, [x, y, z]: [f64; 3], bound: f64) -> Case {
    let scale = Transform::IDENTITY.scale(x, y, z);
    let ours = scale.map(|t| defect(t.matrix(), t.inverse()));
    let what = format!("scale ({x:e}, {y}, {z:e}): the greatest number of |M I - 1|");
    Case::new(id, what, 0.0, Bound::Absolute(bound), ours)
}

fn refused(id: &'static str, what: &str, ours: Step) -> Case {
    let ours = ours.map(|_| true);
    Case::new(id, what, Outcome::Refused, Bound::Equal, ours)
}

fn origin(id: &'static str, what: &str, exact: [f64; 3], ours: Step) -> Case {
    let what = format!("{what}: where the origin goes");
    Case::new(
        id,
        what,
        exact,
        Bound::Equal,
        ours.map(|t| place(t.matrix())),
    )
}

/// The outer step is the scaling: the object is translated first, and the
/// translation is scaled.
fn moved_and_stretched(to: Point3) -> Case {
    let step = Transform::IDENTITY;
    let ours = step.scale(2.0, 2.0, 2.0).and_then(|t| t.translate(to));
    let theirs = || {
        let scale = step.scale(2.0, 2.0, 2.0)?;
        Ok::<_, ArgumentError>(protocol::product(
            scale.matrix(),
            step.translate(to)?.matrix(),
        ))
    };
    origin(
        "G27",
        "scale 2, then within it translate (1, 2, 3)",
        [2.0, 4.0, 6.0],
        ours,
    )
    .protocol(Fails, theirs().map(place))
}

fn full_turn(id: &'static str) -> Case {
    let turned = (0..360).try_fold(Transform::IDENTITY, |t, _| t.rotate_z(TAU / 360.0));
    let point = Point3::new(1.0, 0.0, 0.0);
    let ours = turned.map(|t| (t.matrix() * point).to_glam().to_array());
    let bound = Bound::Absolute(4.0 * 360.0 * f64::EPSILON);
    Case::new(
        id,
        "360 turns by a degree, of (1, 0, 0)",
        [1.0, 0.0, 0.0],
        bound,
        ours,
    )
}

/// Two axes exchanged, which is a reflection: the determinant is -1.
fn sarrus(id: &'static str) -> Case {
    let exchange = [
        [0.0, 1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let what = "determinant of x and y exchanged: glam's, and Sarrus' with four rows";
    let ours = glam::DMat4::from_cols_array_2d(&exchange).determinant();
    Case::new(id, what, -1.0, Bound::Equal, ours)
        .protocol(Fails, protocol::determinant_by_sarrus(exchange))
}
