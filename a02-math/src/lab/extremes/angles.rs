//! Angles too small for an arc cosine, and the numbers of the second text.

use std::f64::consts::FRAC_PI_4;

use measure::extremes::{Case, Equal, Fails, Id, Ulps};

use super::vector;
use crate::lab::protocol;

/// The angle between two vectors, against the protocol's arc cosine.
fn angle(id: Id, what: &str, [a, b]: [[f64; 3]; 2], exact: f64) -> Case {
    let (a, b) = (vector(a), vector(b));
    let bound = if exact == 0.0 { Equal } else { Ulps(4.0) };
    let what = format!("angle between {what}");
    Case::new(id, what, exact, bound, a.angle(b))
        .protocol(Fails, protocol::angle_by_arc_cosine(a, b))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let x_and = |x: f64, y: f64| [[1.0, 0.0, 0.0], [x, y, 0.0]];
    let slanted = |length: f64| [[length, 0.0, 0.0], [length, length, 0.0]];
    let (v, w) = (vector([2.0, 2.5, 10.0]), vector([0.5, 6.0, 4.0]));
    let (on, [a, b]) = (vector([-2.0, -7.0, 3.0]), slanted(1e-100).map(vector));
    vec![
        angle("F01", "x and x turned by 1e-5", x_and(0.999_999_999_95, 9.999_999_999_833_334e-6), 1e-5),
        angle("F02", "x and x turned by 1e-7", x_and(0.999_999_999_999_995, 9.999_999_999_999_982e-8), 1e-7),
        angle("F03", "x and x turned by 1e-8", x_and(1.0, 1e-8), 1e-8),
        angle("F04", "x and x turned by 1e-12", x_and(1.0, 1e-12), 1e-12),
        angle("F05", "x and x turned by pi - 1e-9", x_and(-1.0, 1e-9), 3.141_592_652_589_793),
        Case::new("F28", "angle between (2, 2.5, 10) and (0.5, 6, 4): the text returns the cosine",
            0.740_948_356_444_46, Ulps(4.0), v.angle(w)).protocol(Fails, protocol::angle(v, w)),
        angle("F29", "(1, 1, 1) and itself, the rounded cosine being above 1", [[1.0; 3]; 2], 0.0),
        angle("F30", "vectors of length 1e-200, 45 degrees", slanted(1e-200), FRAC_PI_4),
        angle("F31", "vectors of length 1e200, 45 degrees", slanted(1e200), FRAC_PI_4),
        Case::new("F32", "angle between vectors of length 1e-100, 45 degrees",
            FRAC_PI_4, Ulps(4.0), a.angle(b)),
        Case::new("F33", "(2, 2.5, 10) projected on (-2, -7, 3): 8.5/62 of it, not 8.5/sqrt 62",
            [-0.274_193_548_387_096_75, -0.959_677_419_354_838_7, 0.411_290_322_580_645_2],
            Ulps(2.0), v.projected_on(on)).protocol(Fails, protocol::projected_on(v, on)),
    ]
}
