//! Linear systems by Cramer's rule, whose accuracy the determinant limits.

use measure::extremes::{Absolute, Case, Fails, Holds, Id, Protocol, Ulps};

use super::vector;
use crate::lab::experiments::refined;
use crate::lab::protocol;
use crate::{Mat3x3, Vector3};

fn solved(id: Id, what: &str, exact: [f64; 3], (m, b): (Mat3x3, Vector3), says: Protocol) -> Case {
    let bound = Ulps(4.0);
    Case::new(id, what, exact, bound, refined(m, b)).protocol(says, protocol::cramer(m, b))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let example = Mat3x3::from_rows([[82.0, 45.0, 9.0], [27.0, 16.0, 3.0], [9.0, 5.0, 1.0]]);
    let flat = Mat3x3::from_rows([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]]);
    vec![
        solved("K01", "the system of the text: (82, 45, 9; 27, 16, 3; 9, 5, 1) x = (1, 1, 0)",
            [1.0, 1.0, -14.0], (example, vector([1.0, 1.0, 0.0])), Holds),
        solved("K02", "three columns that are flat but for 2^-40, x = (1, 1, 1)",
            [1.0; 3], nearly_flat(), Fails),
        Case::new("K03", "determinant of (.1, .2, .3; .4, .5, .6; .7, .8, .9): 0 but for rounding",
            4.163_336_342_344_336e-18, Absolute(4.0 * f64::EPSILON), flat.determinant()),
    ]
}

/// The third column differs from the sum of the others by 2^-40 in one
/// coordinate: the sum of all columns is exact, and the solution is (1, 1, 1).
fn nearly_flat() -> (Mat3x3, Vector3) {
    // Truncated to 30 binary digits, so that sums of a few numbers are exact.
    let short = |x: f64| libm::scalbn(libm::scalbn(x, 30).floor(), -30);
    let [a, b] = [[0.3, 0.7, 0.9], [0.5, 0.2, 0.6]].map(|column| vector(column.map(short)));
    let c = a + b + vector([libm::scalbn(1.0, -40), 0.0, 0.0]);
    let m = Mat3x3::IDENTITY
        .change_col_1(a)
        .change_col_2(b)
        .change_col_3(c);
    (m, a + b + c)
}
