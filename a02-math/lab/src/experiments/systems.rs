//! Three equations with three unknowns, from easy to nearly unsolvable.

use std::array;

use glam::DMat3;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Unit};

use super::{WholeNumbers, sets};
use crate::exact::sum_of_products;
use crate::protocol;
use a02_math::arrays::vector;
use a02_math::{Direction, Mat3x3, Vector3};

/// Elimination with the largest number of a column as the pivot.
fn eliminated(m: Mat3x3, b: Vector3) -> Vector3 {
    let mut rows = equations(m, b);
    for column in 0..3 {
        for below in column + 1..3 {
            if rows[below][column].abs() > rows[column][column].abs() {
                rows.swap(below, column);
            }
        }
        let pivot = rows[column];
        for row in &mut rows[column + 1..] {
            let factor = row[column] / pivot[column];
            for (number, above) in row.iter_mut().zip(pivot) {
                *number -= factor * above;
            }
        }
    }
    let z = rows[2][3] / rows[2][2];
    let y = (rows[1][3] - rows[1][2] * z) / rows[1][1];
    let x = (rows[0][3] - rows[0][1] * y - rows[0][2] * z) / rows[0][0];
    Vector3::new(x, y, z)
}

/// Cramer's rule with iterative refinement: the residual is computed from exact
/// products, and the system is solved for it, until it is 0.
pub fn refined(m: Mat3x3, b: Vector3) -> Vector3 {
    let mut x = protocol::cramer(m, b);
    for _ in 0..4 {
        let rest = equations(m, b).map(|[p, q, r, b]| {
            sum_of_products(&[(b, 1.0), (-p, x.x()), (-q, x.y()), (-r, x.z())])
        });
        x = x + protocol::cramer(m, vector(rest));
    }
    x
}

/// The factors of each equation, and its right side.
fn equations(m: Mat3x3, b: Vector3) -> [[f64; 4]; 3] {
    let axes = DMat3::IDENTITY.to_cols_array_2d();
    let [x, y, z] = axes.map(|axis| (m * vector(axis)).to_glam());
    array::from_fn(|row| [x[row], y[row], z[row], b.to_glam()[row]])
}

pub fn experiment() -> Experiment<'static> {
    Experiment::new("linear-systems")
        .asking("How flat may three columns be?")
        .over(Axis::Parameter, "condition number", "systems")
        .with_error("rms error of an unknown")
        .with_unit(Unit::Other("its value is -1, 1 or 3"))
        .with_exact("against the solution that the right side was computed from")
        .with_seeds(&[3])
        .with_curves(|effort| {
            let steps = [0, 5, 10, 15, 20, 25, 30, 35, 40];
            let sets = sets(3, effort, steps, |bits| libm::scalbn(1.0, bits), task);
            let curve = |method, slope: Option<f64>, solve: fn(Mat3x3, Vector3) -> Vector3| {
                let curve = Curve::of_tasks(method, &sets, move |(m, b, _)| solve(*m, *b), errors);
                curve.with_slope(slope, (1e3, 1e12))
            };
            vec![
                curve("Cramer's rule", Some(1.0), protocol::cramer),
                curve("elimination", Some(1.0), eliminated),
                // The solutions are small whole numbers.
                curve("Cramer's rule, mended", None, refined).with_bound(0.0, 0.0..=1e9),
            ]
        })
}

/// A matrix, a right side, and the solution.
type Task = (Mat3x3, Vector3, Vector3);

/// The errors of the unknowns.
fn errors(&(m, b, exact): &Task, x: Vector3) -> [Deviation; 3] {
    let (conditions, error) = (conditions(m, b, exact), (x - exact).to_glam());
    let exact = exact.to_glam();
    array::from_fn(|i| Deviation::new(error[i], exact[i], conditions[i]))
}

/// The conditions of the unknowns: rounding the numbers of `M x = b` moves `x` by
/// `|M⁻¹| (|M| |x| + |b|)` roundings (R. D. Skeel, Scaling for Numerical Stability in Gaussian
/// Elimination, 1979).
pub fn conditions(m: Mat3x3, b: Vector3, x: Vector3) -> [f64; 3] {
    let rows = equations(m, b).map(|[x, y, z, _]| [x, y, z]);
    let (m, x) = (
        DMat3::from_cols_array_2d(&rows).transpose(),
        x.to_glam().abs(),
    );
    (m.inverse().abs() * (m.abs() * x + b.to_glam().abs()) / x).to_array()
}

/// Columns of whole numbers below 2^26. The third is the sum of the others plus
/// numbers that are smaller by a power of two. The right sides are exact sums.
fn task(numbers: &mut WholeNumbers, bits: i32) -> Task {
    let mut column = || vector(array::from_fn(|_| numbers.signed(24)));
    let (a, b, rest) = loop {
        let (a, b, rest) = (column(), column(), column());
        let volume = a.cross(b).dot(rest);
        // Nearly coplanar directions would change the condition number.
        if volume.abs() > 0.3 * a.magnitude() * b.magnitude() * rest.magnitude() {
            break (a, b, rest);
        }
    };
    // Rounded to 20 binary digits behind the point, so that sums are exact.
    let cut = |x: f64| libm::scalbn(libm::scalbn(x, 20 - bits).round(), -20);
    let c = a + b + Vector3::from_glam(rest.to_glam().map(cut));
    let x = vector(array::from_fn(|_| 2.0 * numbers.signed(1) + 1.0));
    let m = from_columns(a, b, c);
    (m, m * x, x)
}

/// The matrix of these columns.
pub fn from_columns(a: Vector3, b: Vector3, c: Vector3) -> Mat3x3 {
    let m = Mat3x3::IDENTITY;
    m.change_col_1(a).change_col_2(b).change_col_3(c)
}
