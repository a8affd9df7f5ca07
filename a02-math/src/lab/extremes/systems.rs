//! Linear systems by Cramer's rule, whose accuracy the determinant limits.

use measure::extremes::{Bound, Case, Protocol};

use super::{triple, vector};
use crate::lab::experiments::refined;
use crate::lab::protocol;
use crate::{Mat3x3, Vector3};

pub fn cases() -> Vec<Case> {
    let example = Mat3x3::from_rows([[82.0, 45.0, 9.0], [27.0, 16.0, 3.0], [9.0, 5.0, 1.0]]);
    let b = vector([1.0, 1.0, 0.0]);
    let flat = Mat3x3::from_rows([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]]);
    vec![
        Case::new(
            "K01",
            "the system of the text: (82, 45, 9; 27, 16, 3; 9, 5, 1) x = (1, 1, 0)",
            [1.0, 1.0, -14.0],
            Bound::Ulps(4.0),
            triple(refined(example, b)),
        )
        .protocol(Protocol::Holds, triple(protocol::cramer(example, b))),
        nearly_flat(),
        Case::new(
            "K03",
            "determinant of (.1, .2, .3; .4, .5, .6; .7, .8, .9): 0 but for rounding",
            4.163_336_342_344_336e-18,
            Bound::Absolute(4.0 * f64::EPSILON),
            flat.determinant(),
        ),
    ]
}

/// The third column differs from the sum of the others by 2^-40 in one
/// coordinate: the sum of all columns is exact, and the solution is (1, 1, 1).
fn nearly_flat() -> Case {
    let step = libm::scalbn(1.0, -40);
    let columns = [[0.3, 0.7, 0.9], [0.5, 0.2, 0.6]].map(|column| column.map(short));
    let [a, b] = columns.map(vector);
    let c = a + b + Vector3::new(step, 0.0, 0.0);
    let m = Mat3x3::IDENTITY
        .change_col_1(a)
        .change_col_2(b)
        .change_col_3(c);
    let right = a + b + c;
    Case::new(
        "K02",
        "three columns that are flat but for 2^-40, x = (1, 1, 1)",
        [1.0; 3],
        Bound::Ulps(4.0),
        triple(refined(m, right)),
    )
    .protocol(Protocol::Fails, triple(protocol::cramer(m, right)))
}

/// The number truncated to 30 binary digits, so that sums of a few of them are
/// exact.
fn short(x: f64) -> f64 {
    libm::scalbn(libm::scalbn(x, 30).floor(), -30)
}
