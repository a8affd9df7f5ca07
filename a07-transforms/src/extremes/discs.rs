//! Rims, radii and grazing rays.

use a02_math::{Normal3, Point3};
use a04_intersections::{Geometry, Interval};
use common::extremes::Protocol::{Fails, Holds};
use common::extremes::{Bound, Case, Outcome, Protocol};

use super::ray;
use crate::{Disc, protocol};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

pub fn cases() -> Vec<Case> {
    let above_diagonal = std::f64::consts::SQRT_2;
    let down = [0.0, -1.0, 0.0];
    let from = |x, z| ([x, 1.0, z], down);
    vec![
        hit(
            "B12",
            "the rim, |p| = r = 5",
            5.0,
            from(3.0, 4.0),
            1.0,
            Fails,
        ),
        hit(
            "B13",
            "|p|² = 2, r = √2 of which the square is 2 + 2^-51",
            above_diagonal,
            from(1.0, 1.0),
            1.0,
            Fails,
        ),
        hit(
            "B14",
            "one unit in the last place outside of the rim",
            5.0,
            from(3.0, 4.0_f64.next_up()),
            Outcome::Nothing,
            Holds,
        ),
        hit(
            "B15",
            "r = -2",
            -2.0,
            from(0.0, 0.0),
            Outcome::Refused,
            Fails,
        ),
        hit(
            "B16",
            "r = 1e-170, whose square is 0",
            1e-170,
            from(0.0, 0.0),
            Outcome::Refused,
            Fails,
        ),
        hit(
            "B17",
            "grazing, through the centre",
            1.0,
            ([-1.0, 1e-16, 0.0], [1.0, -1e-16, 0.0]),
            1.0,
            Holds,
        ),
        hit(
            "B18",
            "a ray within the plane of the disc",
            1.0,
            ([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
            Outcome::Nothing,
            Holds,
        ),
        hit(
            "B31",
            "a slope of 5e-324, t beyond all numbers",
            1.0,
            ([0.0, 1.0, 0.0], [1.0, -5e-324, 0.0]),
            Outcome::Nothing,
            Holds,
        ),
        hit(
            "B32",
            "r = NaN",
            f64::NAN,
            from(0.0, 0.0),
            Outcome::Refused,
            Fails,
        ),
        hit(
            "B33",
            "r = infinity",
            f64::INFINITY,
            from(0.0, 0.0),
            Outcome::Refused,
            Fails,
        ),
    ]
}

/// The `t` at which a ray meets the disc around the origin.
fn hit(
    id: &'static str,
    what: &str,
    r: f64,
    (o, d): ([f64; 3], [f64; 3]),
    exact: impl Into<Outcome>,
    says: Protocol,
) -> Case {
    let ray = ray(o, d);
    let ours = match Disc::new(Point3::ORIGIN, UP, r) {
        Ok(disc) => disc.hit(&ray, Interval::AHEAD).map(|hit| hit.t).into(),
        Err(_) => Outcome::Refused,
    };
    let exact = exact.into();
    let bound = if matches!(exact, Outcome::Number(_)) {
        Bound::Ulps(1.0)
    } else {
        Bound::Equal
    };
    Case::new(id, format!("disc, {what}"), exact, bound, ours)
        .protocol(says, protocol::disc(Point3::ORIGIN, UP, r, &ray))
}
