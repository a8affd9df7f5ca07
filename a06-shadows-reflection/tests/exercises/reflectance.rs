//! Water of the index 4/3, where triangles with sides 3, 4, 5 meet, and other
//! materials by Fresnel's laws of angles.

use a02_math::{Direction, Normal3, Point3};
use a04_intersections::{Geometry, Interval, Plane};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{checkered, show};

const WATER: f64 = 4.0 / 3.0;

pub fn check(check: &mut Check, reflectance: impl Fn(f64, f64, f64) -> f64 + Sync) {
    let mut case = |what: &str, cos: f64, from: f64, to: f64, exact: f64| {
        let what = format!("{what}: cosine {cos}, from the index {from} to {to}");
        let got = reflectance(cos, from, to);
        check.expect(what, exact, Bound::Absolute(1e-11), got);
    };
    case("straight into water", 1.0, 1.0, WATER, 1.0 / 49.0);
    case("straight out of water", 1.0, WATER, 1.0, 1.0 / 49.0);
    case("straight into glass", 1.0, 1.0, 1.5, 0.04);
    // Brewster's angle: one polarisation is not mirrored at all.
    case("aslant into water", 0.6, 1.0, WATER, 0.0392);
    case("aslant out of water", 0.8, WATER, 1.0, 0.0392);
    case("along the water", 0.0, 1.0, WATER, 1.0);
    case("total reflection", 0.6, WATER, 1.0, 1.0);
    case("along the water, from below", 0.0, WATER, 1.0, 1.0);
    case("no surface at all", 0.3, 1.5, 1.5, 0.0);

    // Fresnel's sine and tangent laws (Born and Wolf, Principles of Optics, 1.5.2).
    let mut random = Random::new(3);
    for n in 0..60 {
        let angle = random.between(0.05, 1.5);
        let index = random.between(1.05, 2.5);
        let (from, to) = if n % 2 == 0 {
            (1.0, index)
        } else {
            (index, 1.0)
        };
        let sin = libm::sin(angle) * from / to;
        let exact = if sin >= 1.0 {
            1.0
        } else {
            let beyond = libm::asin(sin);
            let (less, sum) = (angle - beyond, angle + beyond);
            let across = libm::sin(less) / libm::sin(sum);
            let along = libm::tan(less) / libm::tan(sum);
            f64::midpoint(across * across, along * along)
        };
        let what = format!("at the angle {angle}");
        case(&what, libm::cos(angle), from, to, exact);
    }

    // No angle says whether anything is mirrored here.
    let got = reflectance(0.0, 1.5, 1.5);
    let what = "a number along no surface at all: cosine 0, from the index 1.5 to 1.5";
    check.expect(what, 1.0, Bound::Finite, got);

    let up = Normal3::new(0.0, 1.0, 0.0);
    let Ok(lake) = Plane::new(Point3::ORIGIN, up) else {
        return;
    };
    let (eye, at) = (Point3::new(0.0, 2.0, 6.0), Point3::new(0.0, 0.9, 0.0));
    show(check, eye, at, |ray| {
        let d = ray.direction();
        if lake.hit(ray, Interval::AHEAD).is_none() {
            return checkered(d);
        }
        let share = reflectance(-d.dot(up), 1.0, WATER);
        let depth = Color::new(0.0, 0.15, 0.2);
        depth * (1.0 - share) + checkered((-d).reflected_on(up)) * share
    });
}
