//! Triangles hit at corners and edges; thin, tiny, huge and degenerate triangles.

use a02_math::{Normal3, Point3};
use common::ArgumentError;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{Line, MISS, REFUSED, Triple, any_ray, first, meeting, point, raw_ray, unit_ray};
use crate::lab::experiments::Numbers;
use crate::{Geometry, Interval, Triangle, protocol};

type Corners = [Triple; 3];

/// The half of a unit square next to the origin.
const HALF: Corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// The other half.
const OTHER_HALF: Corners = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn triangle(corners: Corners) -> Result<Triangle, ArgumentError> {
    let [a, b, c] = corners.map(point);
    Triangle::new(a, b, c)
}

fn theirs(corners: Corners, line: Line) -> Option<f64> {
    protocol::triangle(&corners.map(point), &any_ray(line))
}

fn case(
    id: &'static str,
    what: &str,
    corners: Corners,
    line: Line,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    Case::new(id, what, exact, bound, meeting(triangle(corners), line))
        .protocol(says, theirs(corners, line))
}

/// Whether the ray hits the first and the second of two neighbours.
fn neighbours(
    id: &'static str,
    what: &str,
    pair: [Corners; 2],
    line: Line,
    right: fn([bool; 2]) -> bool,
) -> Case {
    let ours = || -> Result<bool, ArgumentError> {
        let ray = unit_ray(line)?;
        let [one, other] = [triangle(pair[0])?, triangle(pair[1])?];
        Ok(right([one, other].map(|side| first(&side, &ray).is_some())))
    };
    let theirs = right(pair.map(|corners| theirs(corners, line).is_some()));
    Case::new(id, what, true, Bound::Equal, ours()).protocol(Holds, theirs)
}

/// A triangle of this size, seen from the same distance, at β = γ = 1/4.
fn sized(
    id: &'static str,
    size: f64,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let corners = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]];
    let line = ([0.25 * size, 0.25 * size, size], [0.0, 0.0, -1.0]);
    let what = format!("size and distance {size:e}");
    case(id, &what, corners, line, exact, bound, says)
}

pub fn cases() -> Vec<Case> {
    let mut cases = corners_and_edges();
    cases.extend(needles());
    cases.extend([
        sized("D13", 1e-100, 1e-100, Bound::Ulps(2.0), Fails),
        sized("D14", 1e-107, REFUSED, Bound::Equal, Fails),
        sized("D15", 1e-110, REFUSED, Bound::Equal, Fails),
        sized("D16", 1e-162, REFUSED, Bound::Equal, Fails),
        sized("D17", 1e100, 1e100, Bound::Ulps(2.0), Holds),
        sized("D18", 1e103, REFUSED, Bound::Equal, Fails),
        sized("D19", 1e160, REFUSED, Bound::Equal, Fails),
    ]);
    cases.extend(no_meetings());
    cases.push(by_the_word());
    cases.push(interpolated());
    cases
}

#[rustfmt::skip]
fn corners_and_edges() -> Vec<Case> {
    let at = |x: f64, y: f64| ([x, y, 1.0], [0.0, 0.0, -1.0]);
    let moved = [[0.1, 0.2, 0.3], [1.1, 0.2, 0.3], [0.1, 1.2, 0.3]];
    let below = [HALF[1], HALF[0], [0.0, -1.0, 0.0]];
    let alone = |[this, other]: [bool; 2]| !this && other;
    vec![
        case("D01", "at corner a", HALF, at(0.0, 0.0), 1.0, Bound::Equal, Fails),
        case("D02", "at corner a, elsewhere", moved, at(0.1, 0.2), 0.7, Bound::Ulps(2.0), Fails),
        case("D03", "at corner b", HALF, at(1.0, 0.0), 1.0, Bound::Equal, Holds),
        case("D04", "in the middle of edge bc", HALF, at(0.5, 0.5), 1.0, Bound::Equal, Holds),
        neighbours("D05", "at (0.1, 0.9), a rounding outside of edge bc: one of both neighbours is met",
            [HALF, OTHER_HALF], at(0.1, 0.9), |[one, other]| one || other),
        neighbours("D06", "1e-300 outside of edge ab: only the neighbour is met",
            [HALF, below], at(0.5, -1e-300), alone),
        case("D21", "5e-4 away",
            HALF, ([0.25, 0.25, 5e-4], [0.0, 0.0, -1.0]), 5e-4, Bound::Equal, Fails),
        long_direction(),
        case("D25", "from within the plane, outwards",
            HALF, ([0.25, 0.25, 0.0], [0.0, 0.0, -1.0]), MISS, Bound::Equal, Holds),
    ]
}

#[rustfmt::skip]
fn needles() -> [Case; 3] {
    let flat = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1e-8, 0.0]];
    // a + e and a + e / 2 + f / 1e8, with unit vectors along (1, 2, 3) and (3, 0, -1).
    let slanted = [
        [0.1, 0.2, 0.3],
        [0.367_261_241_912_424_4, 0.734_522_483_824_848_7, 1.101_783_725_737_273_1],
        [0.233_630_630_443_045_2, 0.467_261_241_912_424_4, 0.700_891_859_706_358_9],
    ];
    let near = (
        [-1.788_044, 4.072_455, -2.112_542],
        [2.021_674_624_086_867, -3.605_193_758_087_575_3, 2.813_433_861_825_085],
    );
    let far = (
        [-1_495.805_74, 2_668.310_374, -2_081.240_348],
        [1_496.039_370_624_086_8, -2_667.843_112_758_087_5, 2_081.941_239_861_825],
    );
    [
        case("D07", "a needle of aspect 1e8 along an axis",
            flat, ([0.335, 0.33e-8, 1.0], [0.0, 0.0, -1.0]), 1.0, Bound::Ulps(1.0), Holds),
        case("D08", "a slanted needle of aspect 1e8",
            slanted, near, 5.000_000_041_389_44, Bound::Absolute(5e-11), Fails),
        case("D09", "the same from 3700 away",
            slanted, far, 3_699.999_999_862_901_4, Bound::Absolute(3.7e-8), Fails),
    ]
}

/// The protocol's least distance is in units of the direction's length.
fn long_direction() -> Case {
    let line = ([0.25, 0.25, 1.0], [0.0, 0.0, -1e4]);
    let raw = protocol::triangle(&HALF.map(point), &raw_ray(line));
    let what = "distance 1 along a direction of length 1e4";
    Case::new(
        "D22",
        what,
        1.0,
        Bound::Ulps(2.0),
        meeting(triangle(HALF), line),
    )
    .protocol(Fails, raw.map(|t| t * 1e4))
}

#[rustfmt::skip]
fn no_meetings() -> Vec<Case> {
    let down = [0.0, 0.0, -1.0];
    let on_a_line = [[0.0; 3], [1.0, 1.0, 0.0], [3.0, 3.0, 0.0]];
    let one_third = [[0.1, 0.2, 0.3], [1.1, 2.2, 3.3], [0.4, 0.8, 1.2]];
    // From the tests of pbrt-v4, where single precision once gave a hit.
    let thin = [
        [-1_113.454_59, -79.049_614, -56.243_190_8],
        [-1_113.454_59, -87.092_269_9, -56.243_190_8],
        [-1_113.454_59, -79.209_014_9, -56.243_190_8],
    ];
    let past_it = ([-1_081.479_25, 99.999_954_2, 87.770_111_1], [-32.107_299_8, -183.355_865, -144.607_635]);
    let with = |x: f64| [[x, 0.0, 0.0], HALF[1], HALF[2]];
    let within = ([-1.0, 0.25, 0.0], [1.0, 0.0, 0.0]);
    let inside = ([0.25, 0.25, 1.0], down);
    vec![
        case("D10", "corners on a line, but for rounding",
            one_third, ([0.6, 1.2, 5.0], down), REFUSED, Bound::Equal, Fails),
        case("D11", "corners on a line",
            on_a_line, ([0.5, 0.5, 1.0], down), REFUSED, Bound::Equal, Fails),
        case("D12", "corners on a line, from pbrt's tests",
            thin, past_it, REFUSED, Bound::Equal, Fails),
        case("D20", "along the plane", HALF, within, MISS, Bound::Equal, Holds),
        case("D23", "a corner of NaN", with(f64::NAN), inside, REFUSED, Bound::Equal, Fails),
        case("D24", "an infinite corner",
            with(f64::NEG_INFINITY), inside, REFUSED, Bound::Equal, Fails),
        noise(),
    ]
}

/// For corners on a line up to rounding, the determinant is only rounding error and
/// not 0: the protocol computes hits of some of them, at arbitrary points.
fn noise() -> Case {
    let mut met = [0_usize; 2];
    for n in 0..1000 {
        let mut numbers = Numbers::new(32, n);
        let (a, along) = (numbers.triple(-1.0, 1.0), numbers.direction());
        let share = numbers.between(0.3, 0.7);
        let corners = [a, a + along, a + along * share].map(|way| Point3::ORIGIN + way);
        let back = numbers.direction() * 3.0;
        let aim = corners[0] + along * numbers.between(0.2, 0.8);
        let line = (
            (aim + back).to_glam().to_array(),
            (-back).to_glam().to_array(),
        );
        let ray = any_ray(line);
        let [a, b, c] = corners;
        let ours = Triangle::new(a, b, c).is_ok_and(|triangle| first(&triangle, &ray).is_some());
        let theirs = protocol::triangle(&corners, &ray).is_some();
        met[0] += usize::from(ours);
        met[1] += usize::from(theirs);
    }
    Case::new(
        "D26",
        "1000 times three corners on a line but for rounding: how many are met",
        0.0,
        Bound::Equal,
        met[0],
    )
    .protocol(Fails, met[1])
}

/// Points within a triangle, few of which have β + γ = 1.
fn by_the_word() -> Case {
    let points = (0..1000).map(|n| {
        let mut numbers = Numbers::new(33, n);
        let beta = numbers.between(0.01, 0.98);
        (beta, numbers.between(0.005, 0.99 - beta))
    });
    let met = |&(x, y): &(f64, f64)| {
        meeting(triangle(HALF), ([x, y, 1.0], [0.0, 0.0, -1.0])) == 1.0.into()
    };
    let ours = points.clone().filter(met).count();
    let theirs = points.filter(|(x, y)| protocol::is_inside_by_the_text(*x, *y));
    let what = "1000 points within a triangle: how many are met, β + γ being asked to be 1";
    Case::new("D28", what, 1000.0, Bound::Equal, ours).protocol(Fails, theirs.count())
}

/// The mean of three normals is shorter than each of them.
fn interpolated() -> Case {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let normals = axes.map(|axis| Normal3::from_glam(axis.into()));
    let third = 1.0 / 3.0;
    let length = |normal: Normal3| normal.to_glam().length();
    let ours = || -> Result<_, ArgumentError> {
        let triangle = triangle(HALF)?.with_normals(normals)?;
        let ray = unit_ray(([third, third, 1.0], [0.0, 0.0, -1.0]))?;
        Ok(triangle
            .hit(&ray, Interval::AHEAD)
            .map(|hit| length(hit.normal)))
    };
    let theirs = length(protocol::interpolated_normal(normals, third, third));
    Case::new(
        "D27",
        "three perpendicular normals: the length of their mean",
        1.0,
        Bound::Ulps(2.0),
        ours(),
    )
    .protocol(Fails, theirs)
}
