//! Stiff and extreme cases of vectors, angles and linear systems: the rows of `cases.toml`.

use measure::Effort;
use measure::extremes::{Case, Row, greatest, rows};

use crate::protocol;
use a02_math::arrays::{array, vector};
use a02_math::{Direction, Mat3x3, Normal3, Vector3};

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(include_str!("../cases.toml"), effort, computed)
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    let [a, b] = [0, 3].map(|index| vector(row.triple(index)));
    match row.asks.as_str() {
        "unit" => Case::of(a.normalized().map(array), array(protocol::normalized(a))),
        "reflected" => Case::of(
            reflected(a, b.as_normal()).map(array),
            array(protocol::reflected_on(a, b.as_normal())),
        ),
        "reflected length" => Case::of(
            reflected(a, b.as_normal()).map(Vector3::magnitude),
            protocol::reflected_on(a, b.as_normal()).magnitude(),
        ),
        "perpendicular" => Case::of_ours(defect_of_pair(a)),
        "angle" => Case::of(a.angle(b), protocol::angle_by_arc_cosine(a, b)),
        "angle by the cosine" => Case::of(a.angle(b), protocol::angle(a, b)),
        "projected" => Case::of(
            a.projected_on(b).map(array),
            array(protocol::projected_on(a, b)),
        ),
        "solved" => {
            let solution = protocol::cramer(matrix(row), vector(row.triple(9)));
            Case::of_ours(array(solution))
        }
        "determinant" => Case::of_ours(matrix(row).determinant()),
        _ => Row::unknown(),
    }
}

fn matrix(row: &Row) -> Mat3x3 {
    Mat3x3::from_rows([0, 3, 6].map(|index| row.triple(index)))
}

/// The reflection of an incoming vector by the lesson, on the normalised normal.
fn reflected(d: Vector3, n: Normal3) -> Option<Vector3> {
    Some((-d).reflected_on(n.normalized()?))
}

/// How far the two directions that glam finds perpendicular to a third are from it, after Duff et
/// al.: Building an Orthonormal Basis, Revisited, 2017. They hold where an
/// older formula fails: near -z.
fn defect_of_pair(n: Vector3) -> Option<f64> {
    let n = n.normalized()?;
    let (b, c) = n.to_glam().any_orthonormal_pair();
    let [b, c] = [b, c].map(Vector3::from_glam);
    let cosines = [n.dot(b), n.dot(c), b.dot(c)];
    let lengths = [b.magnitude() - 1.0, c.magnitude() - 1.0];
    Some(greatest(cosines.into_iter().chain(lengths)))
}
