//! Three equations with three unknowns, from easy to nearly unsolvable.

use std::array;

use glam::DMat3;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, ErrorBound, Experiment, Slope, Unit};

use super::{WholeNumbers, task_sets};
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
        let residual = equations(m, b).map(|[p, q, r, b]| {
            let left = [[-p, x.x()], [-q, x.y()], [-r, x.z()]];
            sum_of_products(&[[b, 1.0], left[0], left[1], left[2]])
        });
        x = x + protocol::cramer(m, vector(residual));
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
    Experiment {
        question: "How flat may three columns be?",
        parameter: "condition number",
        work: "systems",
        against: Axis::Parameter,
        error: "rms error of an unknown",
        unit: Unit::Other("its value is -1, 1 or 3"),
        exact: "against the solution that the right side was computed from",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("linear-systems")
    }
}

const SEED: u64 = 3;

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let steps = [0, 5, 10, 15, 20, 25, 30, 35, 40];
    let sets = task_sets(SEED, effort, steps, task);
    let curve = |method, solve: fn(Mat3x3, Vector3) -> Vector3| {
        Curve::of_tasks(
            method,
            &sets,
            move |task: &Task| solve(task.m, task.b),
            errors,
        )
    };
    let as_the_condition = Slope {
        value: 1.0,
        between: 1e3..=1e12,
    };
    vec![
        Curve {
            slope: Some(as_the_condition.clone()),
            ..curve("Cramer's rule", protocol::cramer)
        },
        Curve {
            slope: Some(as_the_condition),
            ..curve("elimination", eliminated)
        },
        Curve {
            // The solutions are small whole numbers.
            bound: Some(ErrorBound {
                error: 0.0,
                between: 0.0..=1e9,
            }),
            ..curve("Cramer's rule, refined", refined)
        },
    ]
}

/// The system `M x = b`, and its solution.
struct Task {
    m: Mat3x3,
    b: Vector3,
    exact: Vector3,
}

/// The errors of the unknowns.
fn errors(task: &Task, x: Vector3) -> [Deviation; 3] {
    let conditions = conditions(task.m, task.b, task.exact);
    let (error, exact) = ((x - task.exact).to_glam(), task.exact.to_glam());
    array::from_fn(|i| Deviation::new(error[i], exact[i], conditions[i]))
}

/// The conditions of the unknowns: rounding the numbers of `M x = b` moves `x` by
/// `|M⁻¹| (|M| |x| + |b|)` roundings (R. D. Skeel, Scaling for Numerical Stability in Gaussian
/// Elimination, 1979).
fn conditions(m: Mat3x3, b: Vector3, x: Vector3) -> [f64; 3] {
    let rows = equations(m, b).map(|[x, y, z, _]| [x, y, z]);
    let m = DMat3::from_cols_array_2d(&rows).transpose();
    let x = x.to_glam().abs();
    let moved = m.abs() * x + b.to_glam().abs();
    (m.inverse().abs() * moved / x).to_array()
}

/// Columns of whole numbers below 2^26. The third is the sum of the others plus
/// numbers that are smaller by a power of two. The right sides are exact sums.
fn task(numbers: &mut WholeNumbers, bits: i32) -> Task {
    let [a, b, rest] = steep_columns(numbers);
    // Rounded to 20 binary digits behind the point, so that sums are exact.
    let cut = |x: f64| libm::scalbn(libm::scalbn(x, 20 - bits).round(), -20);
    let c = a + b + Vector3::from_glam(rest.to_glam().map(cut));
    let exact = vector(array::from_fn(|_| 2.0 * numbers.signed(1) + 1.0));
    let m = from_columns(a, b, c);
    Task {
        m,
        b: m * exact,
        exact,
    }
}

/// Columns that are not nearly in one plane, which would change the condition number.
fn steep_columns(numbers: &mut WholeNumbers) -> [Vector3; 3] {
    loop {
        let columns = [(); 3].map(|()| vector(array::from_fn(|_| numbers.signed(24))));
        let [a, b, c] = columns;
        let volume = a.cross(b).dot(c);
        let lengths = a.magnitude() * b.magnitude() * c.magnitude();
        if volume.abs() > 0.3 * lengths {
            return columns;
        }
    }
}

/// The matrix of these columns.
fn from_columns(a: Vector3, b: Vector3, c: Vector3) -> Mat3x3 {
    let m = Mat3x3::IDENTITY;
    m.change_col_1(a).change_col_2(b).change_col_3(c)
}
