//! Triangles hit at corners and edges; thin, tiny, huge and degenerate triangles.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::extremes::{
    Absolute, Both, Case, Fails, Flag, Holds, Nothing, Number, Refused, Ulps, count_wrong, tried,
};

use super::meeting;
use crate::line::{Line, line};
use crate::protocol;
use crate::subject::TRIANGLE;
use crate::support::{Numbers, Triple, first, point};
use a04_intersections::{Geometry, Interval, Triangle};

type Corners = [Triple; 3];

const DOWN: Triple = [0.0, 0.0, -1.0];
/// The half of a unit square next to the origin.
const HALF: Corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// The other half.
const OTHER_HALF: Corners = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// The neighbour of the first half at its edge ab.
const BELOW: Corners = [HALF[1], HALF[0], [0.0, -1.0, 0.0]];
/// The first half elsewhere.
const MOVED: Corners = [[0.1, 0.2, 0.3], [1.1, 0.2, 0.3], [0.1, 1.2, 0.3]];
/// A needle along an axis.
const FLAT: Corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1e-8, 0.0]];
/// A needle a, a + e and a + e / 2 + f / 1e8, with unit vectors along (1, 2, 3) and (3, 0, -1).
const SLANTED: Corners = [
    [0.1, 0.2, 0.3],
    [
        0.367_261_241_912_424_4,
        0.734_522_483_824_848_7,
        1.101_783_725_737_273_1,
    ],
    [
        0.233_630_630_443_045_2,
        0.467_261_241_912_424_4,
        0.700_891_859_706_358_9,
    ],
];
/// A ray to this needle.
const NEAR: Line = line(
    [-1.788_044, 4.072_455, -2.112_542],
    [
        2.021_674_624_086_867,
        -3.605_193_758_087_575_3,
        2.813_433_861_825_085,
    ],
);
/// Another ray to it, from far away.
const FAR: Line = line(
    [-1_495.805_74, 2_668.310_374, -2_081.240_348],
    [
        1_496.039_370_624_086_8,
        -2_667.843_112_758_087_5,
        2_081.941_239_861_825,
    ],
);
const ON_A_LINE: Corners = [[0.0; 3], [1.0, 1.0, 0.0], [3.0, 3.0, 0.0]];
const ALMOST_ON_A_LINE: Corners = [[0.1, 0.2, 0.3], [1.1, 2.2, 3.3], [0.4, 0.8, 1.2]];
/// From the tests of pbrt-v4, where single precision once gave a hit.
const THIN: Corners = [
    [-1_113.454_59, -79.049_614, -56.243_190_8],
    [-1_113.454_59, -87.092_269_9, -56.243_190_8],
    [-1_113.454_59, -79.209_014_9, -56.243_190_8],
];
const PAST_IT: Line = line(
    [-1_081.479_25, 99.999_954_2, 87.770_111_1],
    [-32.107_299_8, -183.355_865, -144.607_635],
);

/// The line along -z from 1 above the plane z = 0.
fn at(x: f64, y: f64) -> Line {
    line([x, y, 1.0], DOWN)
}

fn triangle(corners: Corners) -> Result<Triangle, ArgumentError> {
    let [a, b, c] = corners.map(point);
    Triangle::new(a, b, c)
}

/// The first hit of a triangle, by our formula and by the protocol's.
fn met(corners: Corners, line: Line) -> Case {
    TRIANGLE.met(&corners.concat(), line)
}

/// A triangle of this size, seen from the same distance, at β = γ = 1/4.
fn sized(size: f64) -> Case {
    let corners = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]];
    met(corners, line([0.25 * size, 0.25 * size, size], DOWN))
}

/// Whether a ray hits the one and the other of two neighbours as it should.
fn neighbours(one: Corners, other: Corners, line: Line, is_right: fn(bool, bool) -> bool) -> Case {
    let (one, other) = (met(one, line), met(other, line));
    let ours = is_right(one.ours != Nothing, other.ours != Nothing);
    let [one, other] = [one.theirs, other.theirs].map(|theirs| theirs != Some(Nothing));
    Case::of(ours, is_right(one, other))
}

/// The distance along a direction of length 1e4: the protocol's least distance is in units of it.
fn along_a_long_direction() -> Case {
    let long = line([0.25, 0.25, 1.0], [0.0, 0.0, -1e4]);
    let theirs = protocol::triangle(&HALF.map(point), &long.raw_ray());
    Case::of(meeting(triangle(HALF), long), theirs.map(|t| t * 1e4))
}

/// The length of the mean of three perpendicular normals, each of which is longer than their mean.
fn mean_of_normals() -> Case {
    const THIRD: f64 = 1.0 / 3.0;
    let normals = [
        Normal3::new(1.0, 0.0, 0.0),
        Normal3::new(0.0, 1.0, 0.0),
        Normal3::new(0.0, 0.0, 1.0),
    ];
    let length = |normal: Normal3| normal.to_glam().length();
    let ours = tried(|| {
        let triangle = triangle(HALF)?.with_normals(normals)?;
        let hit = triangle.hit(&at(THIRD, THIRD).unit_ray()?, Interval::AHEAD);
        Ok(hit.map(|hit| length(hit.normal)))
    });
    let theirs = protocol::interpolated_normal(normals, THIRD, THIRD);
    Case::of(ours, length(theirs))
}

/// How many of 1000 points within a triangle are met. Few of them have β + γ = 1.
fn points_within() -> Case {
    let (mut ours, mut theirs) = (0, 0);
    for n in 0..1000 {
        let mut numbers = Numbers::new(33, n);
        let beta = numbers.between(0.01, 0.98);
        let gamma = numbers.between(0.005, 0.99 - beta);
        let is_met = met(HALF, at(beta, gamma)).ours == Number(1.0);
        ours += usize::from(is_met);
        let is_inside = protocol::is_inside_by_the_text(beta, gamma);
        theirs += usize::from(is_inside);
    }
    Case::of(ours, theirs)
}

pub fn cases() -> Vec<Case> {
    let mut cases = [
        borders(),
        needles(),
        sizes(),
        from_nearby(),
        interpolation(),
    ]
    .concat();
    cases.push(Case::of_wrong(
        "D26",
        "1000 times three corners on a line but for rounding: how many are met",
        noise(),
    ));
    cases
}

/// Corners and edges, which belong to the triangle.
fn borders() -> Vec<Case> {
    vec![
        Case {
            id: "D01",
            what: "at corner a".into(),
            exact: Number(1.0),
            protocol: Fails,
            ..met(HALF, at(0.0, 0.0))
        },
        Case {
            id: "D02",
            what: "at corner a, elsewhere".into(),
            exact: Number(0.7),
            bound: Ulps(2.0),
            protocol: Fails,
            ..met(MOVED, at(0.1, 0.2))
        },
        Case {
            id: "D03",
            what: "at corner b".into(),
            exact: Number(1.0),
            protocol: Holds,
            ..met(HALF, at(1.0, 0.0))
        },
        Case {
            id: "D04",
            what: "in the middle of edge bc".into(),
            exact: Number(1.0),
            protocol: Holds,
            ..met(HALF, at(0.5, 0.5))
        },
        Case {
            id: "D05",
            what: "at (0.1, 0.9), a rounding outside of edge bc: one of both neighbours is met"
                .into(),
            exact: Flag(true),
            protocol: Holds,
            ..neighbours(HALF, OTHER_HALF, at(0.1, 0.9), |one, other| one || other)
        },
        Case {
            id: "D06",
            what: "1e-300 outside of edge ab: only the neighbour is met".into(),
            exact: Flag(true),
            protocol: Holds,
            ..neighbours(HALF, BELOW, at(0.5, -1e-300), |this, other| !this && other)
        },
    ]
}

/// Thin triangles, and corners on a line.
fn needles() -> Vec<Case> {
    vec![
        Case {
            id: "D07",
            what: "a needle of aspect 1e8 along an axis".into(),
            exact: Number(1.0),
            bound: Ulps(1.0),
            protocol: Holds,
            ..met(FLAT, at(0.335, 0.33e-8))
        },
        Case {
            id: "D08",
            what: "a slanted needle of aspect 1e8".into(),
            exact: Number(5.000_000_041_389_44),
            bound: Absolute(5e-11),
            protocol: Fails,
            ..met(SLANTED, NEAR)
        },
        Case {
            id: "D09",
            what: "the same from 3700 away".into(),
            exact: Number(3_699.999_999_862_901_4),
            bound: Absolute(3.7e-8),
            protocol: Fails,
            ..met(SLANTED, FAR)
        },
        Case {
            id: "D10",
            what: "corners on a line, but for rounding".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ALMOST_ON_A_LINE, line([0.6, 1.2, 5.0], DOWN))
        },
        Case {
            id: "D11",
            what: "corners on a line".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ON_A_LINE, at(0.5, 0.5))
        },
        Case {
            id: "D12",
            what: "corners on a line, from pbrt's tests".into(),
            exact: Refused,
            protocol: Fails,
            ..met(THIN, PAST_IT)
        },
    ]
}

/// Triangles from tiny to huge.
fn sizes() -> Vec<Case> {
    vec![
        Case {
            id: "D13",
            what: "size and distance 1e-100".into(),
            exact: Number(1e-100),
            bound: Ulps(2.0),
            protocol: Fails,
            ..sized(1e-100)
        },
        Case {
            id: "D14",
            what: "size and distance 1e-107".into(),
            exact: Refused,
            protocol: Fails,
            ..sized(1e-107)
        },
        Case {
            id: "D15",
            what: "size and distance 1e-110".into(),
            exact: Refused,
            protocol: Fails,
            ..sized(1e-110)
        },
        Case {
            id: "D16",
            what: "size and distance 1e-162".into(),
            exact: Refused,
            protocol: Fails,
            ..sized(1e-162)
        },
        Case {
            id: "D17",
            what: "size and distance 1e100".into(),
            exact: Number(1e100),
            bound: Ulps(2.0),
            protocol: Holds,
            ..sized(1e100)
        },
        Case {
            id: "D18",
            what: "size and distance 1e103".into(),
            exact: Refused,
            protocol: Fails,
            ..sized(1e103)
        },
        Case {
            id: "D19",
            what: "size and distance 1e160".into(),
            exact: Refused,
            protocol: Fails,
            ..sized(1e160)
        },
        Case {
            id: "D23",
            what: "a corner of NaN".into(),
            exact: Refused,
            protocol: Fails,
            ..met([[f64::NAN, 0.0, 0.0], HALF[1], HALF[2]], at(0.25, 0.25))
        },
        Case {
            id: "D24",
            what: "an infinite corner".into(),
            exact: Refused,
            protocol: Fails,
            ..met(
                [[f64::NEG_INFINITY, 0.0, 0.0], HALF[1], HALF[2]],
                at(0.25, 0.25),
            )
        },
    ]
}

/// Rays from the triangle or just before it, and along its plane.
fn from_nearby() -> Vec<Case> {
    vec![
        Case {
            id: "D20",
            what: "along the plane".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(HALF, line([-1.0, 0.25, 0.0], [1.0, 0.0, 0.0]))
        },
        Case {
            id: "D29",
            what: "from a point of it, along its plane".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(HALF, line([0.25, 0.25, 0.0], [1.0, 0.0, 0.0]))
        },
        Case {
            id: "D21",
            what: "5e-4 away".into(),
            exact: Number(5e-4),
            protocol: Fails,
            ..met(HALF, line([0.25, 0.25, 5e-4], DOWN))
        },
        Case {
            id: "D22",
            what: "distance 1 along a direction of length 1e4".into(),
            exact: Number(1.0),
            bound: Ulps(2.0),
            protocol: Fails,
            ..along_a_long_direction()
        },
        Case {
            id: "D25",
            what: "from within the plane, outwards".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(HALF, line([0.25, 0.25, 0.0], DOWN))
        },
    ]
}

/// Barycentric coordinates, and what is interpolated with them.
fn interpolation() -> Vec<Case> {
    vec![
        Case {
            id: "D27",
            what: "three perpendicular normals: the length of their mean".into(),
            exact: Number(1.0),
            bound: Ulps(2.0),
            protocol: Fails,
            ..mean_of_normals()
        },
        Case {
            id: "D28",
            what: "1000 points within a triangle: how many are met, β + γ being asked to be 1"
                .into(),
            exact: Number(1000.0),
            protocol: Fails,
            ..points_within()
        },
    ]
}

/// For corners on a line up to rounding, the determinant is only rounding error and
/// not 0: the protocol computes hits of some of them, at arbitrary points.
fn noise() -> Result<Both<usize>, ArgumentError> {
    count_wrong(0..1000, |n| {
        let mut numbers = Numbers::new(32, n);
        let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
        let along = numbers.direction();
        let (b, c) = (a + along, a + along * numbers.between(0.3, 0.7));
        let back = numbers.direction() * 3.0;
        let target = a + along * numbers.between(0.2, 0.8);
        let ray = Ray::new(target + back, -back)?;
        let ours = Triangle::new(a, b, c).map(|triangle| first(&triangle, &ray));
        Ok(Both {
            ours: ours.is_ok_and(|t| t.is_some()),
            theirs: protocol::triangle(&[a, b, c], &ray).is_some(),
        })
    })
}
