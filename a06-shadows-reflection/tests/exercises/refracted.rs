//! Water of the index 4/3, where triangles with sides 3, 4, 5 meet.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Sphere};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{checkered, show};

const WATER: f64 = 4.0 / 3.0;

pub fn check(
    check: &mut Check,
    refracted: impl Fn(Vector3, Normal3, f64) -> Option<Vector3> + Sync,
) {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let bound = Bound::Absolute(1e-14);
    for (x, z) in [(1.0, 0.0), (0.0, -1.0), (0.6, 0.8), (-0.96, 0.28)] {
        let way = |sin: f64, y: f64| Vector3::new(sin * x, y, sin * z);
        let mut case = |what: &str, d: Vector3, index: f64, exact: Option<Vector3>| {
            let array = |d: Vector3| d.to_glam().to_array();
            let got = refracted(d, up, index).map(array);
            let what = format!("{what}, index {index}, direction {}", d.to_glam());
            check.expect(what, exact.map(array), bound, got);
        };
        case("into water", way(0.8, -0.6), WATER, Some(way(0.6, -0.8)));
        case("out of water", way(0.6, 0.8), WATER, Some(way(0.8, 0.6)));
        case("straight in", way(0.0, -1.0), WATER, Some(way(0.0, -1.0)));
        case("straight out", way(0.0, 1.0), WATER, Some(way(0.0, 1.0)));
        case("into air", way(0.6, -0.8), 1.0, Some(way(0.6, -0.8)));
        case(
            "out of water at too large an angle",
            way(0.8, 0.6),
            WATER,
            None,
        );
        // Total reflection begins at the sine 3/4.
        let cos = |sin: f64| (1.0 - sin * sin).sqrt();
        case(
            "just beyond the limit",
            way(0.7501, cos(0.7501)),
            WATER,
            None,
        );
        let inside = refracted(way(0.7499, cos(0.7499)), up, WATER).is_some();
        check.expect(
            "just before the limit it gets out",
            true,
            Bound::Equal,
            inside,
        );
    }

    let mut random = Random::new(4);
    for _ in 0..60 {
        let [n, other] = [(); 2].map(|()| Vector3::from_glam(random.unit().into()));
        let Some(aside) = n.cross(other).normalized() else {
            continue;
        };
        // The smaller sine is that inside.
        let index = random.between(1.05, 2.5);
        let inside = random.between(0.0, 0.99) / index;
        let way = |sin: f64, up: f64| aside * sin + n * (up * (1.0 - sin * sin).sqrt());
        let mut expect = |what: &str, d: Vector3, exact: Option<Vector3>| {
            let array = |d: Vector3| d.to_glam().to_array();
            let got = refracted(d, n.as_normal(), index).map(array);
            let what = format!(
                "{what}, index {index}, normal {:.3}, direction {:.3}",
                n.to_glam(),
                d.to_glam()
            );
            check.expect(what, exact.map(array), Bound::Absolute(1e-13), got);
        };
        let outside = inside * index;
        expect("in", way(outside, -1.0), Some(way(inside, -1.0)));
        expect("out", way(inside, 1.0), Some(way(outside, 1.0)));
        expect(
            "mirrored",
            way(random.between(1.01, index - 0.01) / index, 1.0),
            None,
        );
    }

    let Ok(ball) = Sphere::new(Point3::ORIGIN, 1.0) else {
        return;
    };
    show(check, Point3::new(0.4, 0.3, 3.6), Point3::ORIGIN, |ray| {
        through(&ball, ray, &refracted).unwrap_or(Color::new(0.8, 0.1, 0.1))
    });
}

/// The colour seen through a ball of glass; none where no light gets out.
fn through(
    ball: &Sphere,
    ray: &Ray,
    refracted: impl Fn(Vector3, Normal3, f64) -> Option<Vector3>,
) -> Option<Color> {
    let glass = 1.5;
    let Some(hit) = ball.hit(ray, Interval::AHEAD) else {
        return Some(checkered(ray.direction()));
    };
    let inside = Ray::derived(
        ray.at(hit.t),
        refracted(ray.direction(), hit.normal, glass)?,
    );
    // The far end of the chord of a ball around the origin.
    let t = 2.0 * inside.t_of(Point3::ORIGIN);
    let normal = (inside.at(t) - Point3::ORIGIN).normalized()?.as_normal();
    Some(checkered(refracted(inside.direction(), normal, glass)?))
}
