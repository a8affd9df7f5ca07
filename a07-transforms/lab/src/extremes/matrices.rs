//! Chains of transforms: matrix times inverse is the identity.

use std::f64::consts::FRAC_PI_2;

use a02_math::Point3;
use a02_math::arrays::array;
use common::ArgumentError;
use glam::DMat4;
use measure::extremes::{Case, Outcome, Row, greatest, tried};

use crate::protocol::{self, Chained};
use a07_transforms::{Mat4x4, Transform};

type Step = Result<Transform, ArgumentError>;

/// A transform by our formulas and by the protocol's.
pub struct Chain {
    pub ours: Transform,
    pub theirs: Chained,
}

impl Chain {
    const START: Self = Self {
        ours: Transform::IDENTITY,
        theirs: Chained::IDENTITY,
    };

    /// The chain with one more step, or with several that count as one for the protocol.
    fn then(self, step: impl Fn(Transform) -> Step) -> Result<Self, ArgumentError> {
        let alone = step(Transform::IDENTITY)?;
        Ok(Self {
            ours: step(self.ours)?,
            theirs: self.theirs.then(&alone),
        })
    }

    /// Rotations about x, y and z in turn, by angles from 1 to 1.9.
    fn turns(count: u32) -> Result<Self, ArgumentError> {
        let mut chain = Self::START;
        for i in 0..count {
            chain = chain.then(|t| turn(t, i))?;
        }
        Ok(chain)
    }

    fn moved_and_turned() -> Result<Self, ArgumentError> {
        let moved = Self::START.then(|t| t.translate(TO))?;
        moved.then(|t| t.rotate_y(FRAC_PI_2))
    }

    /// Two rotations, a scaling of one axis by `k`, and two more rotations: the
    /// condition number of the product is `k`.
    pub fn stretched(k: f64) -> Result<Self, ArgumentError> {
        let turned = Self::START.then(|t| t.rotate_x(0.5)?.rotate_y(0.5))?;
        let stretched = turned.then(|t| t.scale(k, 1.0, 1.0))?;
        stretched.then(|t| t.rotate_y(0.5)?.rotate_z(0.5))
    }
}

/// A step that does nothing.
const NO_STEP: Transform = Transform::IDENTITY;

/// The vector of the translations.
const TO: Point3 = Point3::new(1.0, 2.0, 3.0);

/// The transform after the `i`-th of these rotations.
pub fn turn(t: Transform, i: u32) -> Step {
    let axes = [
        Transform::rotate_x,
        Transform::rotate_y,
        Transform::rotate_z,
    ];
    axes[i as usize % 3](t, 1.0 + 0.1 * f64::from(i % 10))
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

/// How far the product of matrix and inverse is from the identity.
fn identity(chain: &Result<Chain, ArgumentError>) -> Case {
    let theirs = chain
        .as_ref()
        .map(|chain| greatest(off_identity(chain.theirs.m, chain.theirs.i)));
    let ours = chain.as_ref().map(|chain| defect(&chain.ours));
    Case::of(ours, theirs)
}

/// Where the origin goes.
fn origin(step: Step) -> Outcome {
    step.map(|t| array(t.matrix() * Point3::ORIGIN)).into()
}

/// What a row asks: how far the product of matrix and inverse is from the identity, after some steps.
pub fn computed(row: &Row) -> Case {
    match row.asks.as_str() {
        "turns" => identity(&Chain::turns(row.number(0) as u32)),
        "stretched" => identity(&Chain::stretched(row.number(0))),
        "scale" => {
            let [x, y, z] = row.triple(0);
            Case::of_ours(NO_STEP.scale(x, y, z).map(|t| defect(&t)))
        }
        "moved and turned" => identity(&Chain::moved_and_turned()),
        "translated" => translated(),
        "scaled and translated" => scaled_and_translated(),
        "determinant by Sarrus" => determinant(),
        _ => Row::unknown(),
    }
}

/// The translation by the protocol, which writes it into the last row.
fn translated() -> Case {
    let translation = NO_STEP.translate(TO);
    let theirs = translation.clone().map(|t| {
        let matrix = protocol::translation_in_last_row(&t);
        array(matrix * Point3::ORIGIN)
    });
    Case::of(origin(translation), theirs)
}

/// A scaling, and within it a translation: the object is translated first, and the displacement is
/// scaled. The protocol's program exchanges the factors.
fn scaled_and_translated() -> Case {
    let ours = NO_STEP.scale(2.0, 2.0, 2.0).and_then(|t| t.translate(TO));
    let theirs = tried(|| {
        let scale = NO_STEP.scale(2.0, 2.0, 2.0)?.matrix();
        let translation = NO_STEP.translate(TO)?.matrix();
        Ok(array(
            protocol::product(scale, translation) * Point3::ORIGIN,
        ))
    });
    Case::of(origin(ours), theirs)
}

/// Two axes exchanged, which is a reflection: the determinant is -1.
fn determinant() -> Case {
    let exchange = [
        [0.0, 1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    Case::of(
        DMat4::from_cols_array_2d(&exchange).determinant(),
        protocol::determinant_by_sarrus(exchange),
    )
}
