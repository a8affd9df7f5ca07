//! A problem of this stage from harmless to extreme.

use a02_math::{Direction, Point3, Vector3};
use a07_transforms::Mat4x4;
use measure::extremes::{AgainstProtocol, greatest};
use measure::sweep::{Point, Sweep};

use crate::extremes::matrices::{Chain, off_identity};

/// Matrix and inverse by the lesson and by the protocol, of a chain that stretches.
fn matrices(factor: f64) -> AgainstProtocol<Option<[Mat4x4; 2]>> {
    let Ok(chain) = Chain::stretched(factor) else {
        return AgainstProtocol::default();
    };
    AgainstProtocol {
        ours: Some([chain.ours.matrix(), chain.ours.inverse()]),
        theirs: Some([chain.theirs.m, chain.theirs.i]),
    }
}

/// The factor by which a chain of transforms stretches one axis.
pub const STRETCHED: Sweep = Sweep {
    name: "matrix",
    parameter: "factor by which a matrix stretches one axis, between rotations",
    computes: "the greatest number of |M I - 1|, where I is the inverse of the matrix M",
    shows: "A chessboard whose points went there by M and back by I.",
    stage: "a07-transforms",
    powers: [0.0, 16.0],
    harmless: 0.0,
    step: 0.25,
    unit: None,
    exercise: None,
    at: |factor| {
        let defect = |[m, i]: [Mat4x4; 2]| greatest(off_identity(m, i));
        Point {
            given: vec![factor],
            factor: 1.0,
            exact: 0.0.into(),
            size: 1.0,
            condition: factor,
            found: matrices(factor).map(|found| found.map(defect)),
        }
    },
    picture: |factor, [x, y]| {
        let way = Vector3::new(x, y, 0.0);
        let field = |[m, i]: [Mat4x4; 2]| {
            let back = i * (m * (Point3::ORIGIN + way)) - Point3::ORIGIN;
            let [column, row] = [[1.0, 0.0], [0.0, 1.0]]
                .map(|[x, y]| libm::floor(3.0 * back.dot(Vector3::new(x, y, 0.0))) as i64);
            if (column + row) % 2 == 0 { 0.85 } else { 0.3 }
        };
        matrices(factor).map(|found| found.map(field))
    },
};
