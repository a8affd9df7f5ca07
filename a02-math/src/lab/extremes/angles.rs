//! Angles too small for an arc cosine, and the numbers of the second text.

use std::f64::consts::FRAC_PI_4;

use measure::extremes::{Bound, Case, Protocol};

use super::{triple, vector};
use crate::Vector3;
use crate::lab::protocol;

const X: Vector3 = vector([1.0, 0.0, 0.0]);

pub fn cases() -> Vec<Case> {
    let mut cases = tiny();
    cases.extend(other_angles());
    cases.extend(projections());
    cases
}

fn tiny() -> Vec<Case> {
    let row = |id, what: &str, exact: f64, [x, y]: [f64; 2]| {
        let turned = vector([x, y, 0.0]);
        let what = format!("angle between x and x turned by {what}");
        Case::new(id, what, exact, Bound::Ulps(4.0), X.angle(turned))
            .protocol(Protocol::Fails, protocol::angle_by_arc_cosine(X, turned))
    };
    vec![
        row(
            "F01",
            "1e-5",
            1e-5,
            [0.999_999_999_95, 9.999_999_999_833_334e-6],
        ),
        row(
            "F02",
            "1e-7",
            1e-7,
            [0.999_999_999_999_995, 9.999_999_999_999_982e-8],
        ),
        row("F03", "1e-8", 1e-8, [1.0, 1e-8]),
        row("F04", "1e-12", 1e-12, [1.0, 1e-12]),
        row("F05", "pi - 1e-9", 3.141_592_652_589_793, [-1.0, 1e-9]),
    ]
}

fn other_angles() -> Vec<Case> {
    let row = |id, what: &str, exact: f64, bound, theirs: f64, [a, b]: [[f64; 3]; 2]| {
        Case::new(id, what, exact, bound, vector(a).angle(vector(b)))
            .protocol(Protocol::Fails, theirs)
    };
    let (v, w) = ([2.0, 2.5, 10.0], [0.5, 6.0, 4.0]);
    let ones = [1.0; 3];
    let arc_cosine = |a, b| protocol::angle_by_arc_cosine(vector(a), vector(b));
    let slanted = |length: f64| [[length, 0.0, 0.0], [length, length, 0.0]];
    let far = |id, what, length| {
        let [a, b] = slanted(length);
        row(
            id,
            what,
            FRAC_PI_4,
            Bound::Ulps(4.0),
            arc_cosine(a, b),
            [a, b],
        )
    };
    vec![
        row(
            "F28",
            "angle between (2, 2.5, 10) and (0.5, 6, 4): the text returns the cosine",
            0.740_948_356_444_46,
            Bound::Ulps(4.0),
            protocol::angle(vector(v), vector(w)),
            [v, w],
        ),
        row(
            "F29",
            "angle between (1, 1, 1) and itself, the rounded cosine being above 1",
            0.0,
            Bound::Equal,
            arc_cosine(ones, ones),
            [ones, ones],
        ),
        far(
            "F30",
            "angle between vectors of length 1e-200, 45 degrees",
            1e-200,
        ),
        far(
            "F31",
            "angle between vectors of length 1e200, 45 degrees",
            1e200,
        ),
        Case::new(
            "F32",
            "angle between vectors of length 1e-100, 45 degrees",
            FRAC_PI_4,
            Bound::Ulps(4.0),
            vector([1e-100, 0.0, 0.0]).angle(vector([1e-100, 1e-100, 0.0])),
        ),
    ]
}

fn projections() -> Vec<Case> {
    let (v, on) = (vector([2.0, 2.5, 10.0]), vector([-2.0, -7.0, 3.0]));
    vec![
        Case::new(
            "F33",
            "(2, 2.5, 10) projected on (-2, -7, 3): 8.5/62 of it, not 8.5/sqrt 62",
            [
                -0.274_193_548_387_096_75,
                -0.959_677_419_354_838_7,
                0.411_290_322_580_645_2,
            ],
            Bound::Ulps(2.0),
            v.projected_on(on).map(triple),
        )
        .protocol(Protocol::Fails, triple(protocol::projected_on(v, on))),
    ]
}
