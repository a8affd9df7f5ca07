//! Triangles hit at corners and edges; thin, tiny, huge and degenerate triangles.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::extremes::{Absolute, Both, Case, Equal, Fails, Holds, Ulps};
use measure::extremes::{case, tried, wrong};

use super::{MISS, REFUSED, meeting};
use crate::protocol;
use crate::subject::TRIANGLE;
use crate::support::{Line, Numbers, Triple, first, point, raw_ray, unit_ray};
use a04_intersections::{Geometry, Interval, Triangle};

type Corners = [Triple; 3];

const DOWN: Triple = [0.0, 0.0, -1.0];
/// The half of a unit square next to the origin.
const HALF: Corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// The other half.
const OTHER_HALF: Corners = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn triangle(corners: Corners) -> Result<Triangle, ArgumentError> {
    let [a, b, c] = corners.map(point);
    Triangle::new(a, b, c)
}

/// The first hit of a triangle, by our formula and by the protocol's.
fn met(corners: Corners, line: Line) -> Both {
    TRIANGLE.met(&corners.concat(), line)
}

/// A triangle of this size, seen from the same distance, at β = γ = 1/4.
fn sized(size: f64) -> Both {
    let corners = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]];
    met(corners, ([0.25 * size, 0.25 * size, size], DOWN))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let at = |x: f64, y: f64| ([x, y, 1.0], DOWN);
    let moved = [[0.1, 0.2, 0.3], [1.1, 0.2, 0.3], [0.1, 1.2, 0.3]];
    let below = [HALF[1], HALF[0], [0.0, -1.0, 0.0]];
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
    let on_a_line = [[0.0; 3], [1.0, 1.0, 0.0], [3.0, 3.0, 0.0]];
    let nearly = [[0.1, 0.2, 0.3], [1.1, 2.2, 3.3], [0.4, 0.8, 1.2]];
    // From the tests of pbrt-v4, where single precision once gave a hit.
    let thin = [-79.049_614, -87.092_269_9, -79.209_014_9].map(|y| [-1_113.454_59, y, -56.243_190_8]);
    let past_it = ([-1_081.479_25, 99.999_954_2, 87.770_111_1], [-32.107_299_8, -183.355_865, -144.607_635]);
    let with = |x: f64| [[x, 0.0, 0.0], HALF[1], HALF[2]];
    let inside = at(0.25, 0.25);
    // The protocol's least distance is in units of the direction's length.
    let long = ([0.25, 0.25, 1.0], [0.0, 0.0, -1e4]);
    let raw = protocol::triangle(&HALF.map(point), &raw_ray(long));
    // Whether the ray hits the one and the other of two neighbours as it should.
    let neighbours = |pair: [Corners; 2], line, right: fn([bool; 2]) -> bool| {
        let hits = pair.map(|corners| met(corners, line).outcomes.map(|outcome| outcome != MISS));
        [0, 1].map(|by| right(hits.map(|hits| hits[by])).into())
    };
    // The mean of three normals is shorter than each of them.
    let normals = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|n| Normal3::from_glam(n.into()));
    let length = |normal: Normal3| normal.to_glam().length();
    let mean = tried(|| {
        let triangle = triangle(HALF)?.with_normals(normals)?;
        let hit = triangle.hit(&unit_ray(at(1.0 / 3.0, 1.0 / 3.0))?, Interval::AHEAD);
        Ok(hit.map(|hit| length(hit.normal)))
    });
    // Points within a triangle, few of which have β + γ = 1.
    let points = (0..1000).map(|n| {
        let mut numbers = Numbers::new(33, n);
        let beta = numbers.between(0.01, 0.98);
        (beta, numbers.between(0.005, 0.99 - beta))
    });
    let is_met = |&(x, y): &(f64, f64)| met(HALF, at(x, y)).outcomes[0] == 1.0.into();
    let by_the_text = points.clone().filter(|(x, y)| protocol::is_inside_by_the_text(*x, *y));
    vec![
        case("D01", "at corner a", met(HALF, at(0.0, 0.0)), 1.0, Equal, Fails),
        case("D02", "at corner a, elsewhere", met(moved, at(0.1, 0.2)), 0.7, Ulps(2.0), Fails),
        case("D03", "at corner b", met(HALF, at(1.0, 0.0)), 1.0, Equal, Holds),
        case("D04", "in the middle of edge bc", met(HALF, at(0.5, 0.5)), 1.0, Equal, Holds),
        case("D05", "at (0.1, 0.9), a rounding outside of edge bc: one of both neighbours is met",
            neighbours([HALF, OTHER_HALF], at(0.1, 0.9), |[one, other]| one || other), true, Equal, Holds),
        case("D06", "1e-300 outside of edge ab: only the neighbour is met",
            neighbours([HALF, below], at(0.5, -1e-300), |[this, other]| !this && other), true, Equal, Holds),
        case("D07", "a needle of aspect 1e8 along an axis", met(flat, at(0.335, 0.33e-8)), 1.0, Ulps(1.0), Holds),
        case("D08", "a slanted needle of aspect 1e8",
            met(slanted, near), 5.000_000_041_389_44, Absolute(5e-11), Fails),
        case("D09", "the same from 3700 away", met(slanted, far), 3_699.999_999_862_901_4, Absolute(3.7e-8), Fails),
        case("D10", "corners on a line, but for rounding",
            met(nearly, ([0.6, 1.2, 5.0], DOWN)), REFUSED, Equal, Fails),
        case("D11", "corners on a line", met(on_a_line, at(0.5, 0.5)), REFUSED, Equal, Fails),
        case("D12", "corners on a line, from pbrt's tests", met(thin, past_it), REFUSED, Equal, Fails),
        case("D13", "size and distance 1e-100", sized(1e-100), 1e-100, Ulps(2.0), Fails),
        case("D14", "size and distance 1e-107", sized(1e-107), REFUSED, Ulps(2.0), Fails),
        case("D15", "size and distance 1e-110", sized(1e-110), REFUSED, Ulps(2.0), Fails),
        case("D16", "size and distance 1e-162", sized(1e-162), REFUSED, Ulps(2.0), Fails),
        case("D17", "size and distance 1e100", sized(1e100), 1e100, Ulps(2.0), Holds),
        case("D18", "size and distance 1e103", sized(1e103), REFUSED, Ulps(2.0), Fails),
        case("D19", "size and distance 1e160", sized(1e160), REFUSED, Ulps(2.0), Fails),
        case("D20", "along the plane", met(HALF, ([-1.0, 0.25, 0.0], [1.0, 0.0, 0.0])), MISS, Equal, Holds),
        case("D29", "from a point of it, along its plane",
            met(HALF, ([0.25, 0.25, 0.0], [1.0, 0.0, 0.0])), MISS, Equal, Holds),
        case("D21", "5e-4 away", met(HALF, ([0.25, 0.25, 5e-4], DOWN)), 5e-4, Equal, Fails),
        Case::new("D22", "distance 1 along a direction of length 1e4",
            1.0, Ulps(2.0), meeting(triangle(HALF), long)).protocol(Fails, raw.map(|t| t * 1e4)),
        case("D23", "a corner of NaN", met(with(f64::NAN), inside), REFUSED, Equal, Fails),
        case("D24", "an infinite corner", met(with(f64::NEG_INFINITY), inside), REFUSED, Equal, Fails),
        case("D25", "from within the plane, outwards", met(HALF, ([0.25, 0.25, 0.0], DOWN)), MISS, Equal, Holds),
        Case::wrong("D26", "1000 times three corners on a line but for rounding: how many are met", noise()),
        Case::new("D27", "three perpendicular normals: the length of their mean", 1.0, Ulps(2.0), mean)
            .protocol(Fails, length(protocol::interpolated_normal(normals, 1.0 / 3.0, 1.0 / 3.0))),
        Case::new("D28", "1000 points within a triangle: how many are met, β + γ being asked to be 1",
            1000.0, Equal, points.filter(is_met).count()).protocol(Fails, by_the_text.count()),
    ]
}

/// For corners on a line up to rounding, the determinant is only rounding error and
/// not 0: the protocol computes hits of some of them, at arbitrary points.
fn noise() -> Result<[usize; 2], ArgumentError> {
    wrong(0..1000, |n| {
        let mut numbers = Numbers::new(32, n);
        let (a, along) = (numbers.triple(-1.0, 1.0), numbers.direction());
        let fraction = numbers.between(0.3, 0.7);
        let corners = [a, a + along, a + along * fraction].map(|way| Point3::ORIGIN + way);
        let back = numbers.direction() * 3.0;
        let aim = corners[0] + along * numbers.between(0.2, 0.8);
        let (ray, [a, b, c]) = (Ray::new(aim + back, -back)?, corners);
        let is_met = Triangle::new(a, b, c).is_ok_and(|triangle| first(&triangle, &ray).is_some());
        Ok([is_met, protocol::triangle(&corners, &ray).is_some()])
    })
}
