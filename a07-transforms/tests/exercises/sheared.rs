//! Points of a leaning ball and a leaning box, whose normals are known.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, World};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, show};

pub fn check<B: Geometry + 'static, A: Geometry + 'static>(
    check: &mut Check,
    ball: impl Fn(Sphere, f64) -> B,
    aab: impl Fn(AxisAlignedBox, f64) -> A,
) {
    let Ok(sphere) = Sphere::new(Point3::ORIGIN, 1.0) else {
        return;
    };
    let mut random = Random::new(4);
    let more: Vec<_> = (0..8).map(|_| random.between(-3.0, 3.0)).collect();
    for by in [0.75, 0.0, -2.0].into_iter().chain(more) {
        let leaning = ball(sphere, by);
        for (sin, cos) in TURNS {
            for (high, around) in [(0.6, 0.8), (-0.8, 0.6), (0.0, 1.0), (1.0, 0.0)] {
                let (x, y, z) = (cos * around, high, sin * around);
                let place = Point3::new(x + by * y, y, z);
                // The gradient of (x - by y)² + y² + z² = 1.
                let gradient = Vector3::new(x, y - by * x, z);
                let Some(exact) = gradient.normalized() else {
                    return;
                };
                // Nothing of a convex body lies before it.
                for length in [2.0, 0.5] {
                    let ray = Ray::derived(place + exact * 2.0, exact * -length);
                    let got = leaning.hit(&ray, Interval::AHEAD);
                    let what = format!(
                        "a ball sheared by {by}, at {:.3}, direction of length {length}",
                        place.to_glam()
                    );
                    expect(check, &what, 2.0 / length, exact, got);
                }
            }
        }
    }

    let corner = Point3::new(1.0, 2.0, 1.0);
    if let Ok(cube) = AxisAlignedBox::new(Point3::new(-1.0, 0.0, -1.0), corner) {
        let leaning = aab(cube, 0.75);
        // The right face has gone through (1, 0) and (2.5, 2).
        let exact = Vector3::new(0.8, -0.6, 0.0);
        let place = Point3::new(1.75, 1.0, 0.2);
        let ray = Ray::derived(place + exact, -exact);
        let got = leaning.hit(&ray, Interval::AHEAD);
        expect(check, "the right face of a leaning box", 1.0, exact, got);
        // The top is where it was, but farther right.
        let up = Vector3::new(0.0, 1.0, 0.0);
        let ray = Ray::derived(Point3::new(2.4, 5.0, 0.0), -up);
        let got = leaning.hit(&ray, Interval::AHEAD);
        expect(check, "the top of a leaning box", 3.0, up, got);
    }

    let world = || {
        let (lbf, run) = (Point3::new(-2.3, 0.0, -0.7), Point3::new(-1.0, 2.0, 0.7));
        let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
        let round = Sphere::new(Point3::new(0.9, 1.0, 0.0), 1.0)?;
        Ok(World::new(Color::gray(0.08))?
            .with(floor, Color::gray(0.6))
            .with(
                aab(AxisAlignedBox::new(lbf, run)?, 0.6),
                Color::new(0.4, 0.7, 1.0),
            )
            .with(ball(round, 0.6), Color::new(1.0, 0.5, 0.3)))
    };
    let (eye, at) = (Point3::new(0.3, 2.6, 7.5), Point3::new(0.3, 0.8, 0.0));
    show(check, world(), eye, at);
}

fn expect(check: &mut Check, what: &str, t: f64, normal: Vector3, got: Option<Hit>) {
    let bound = Bound::Absolute(1e-12);
    check.expect(format!("t, {what}"), Some(t), bound, got.map(|hit| hit.t));
    if let Some(hit) = got {
        for (of, got) in [("normal", hit.normal), ("face", hit.face)] {
            let got = got.to_glam().to_array();
            check.expect(
                format!("{of}, {what}"),
                normal.to_glam().to_array(),
                bound,
                got,
            );
        }
    }
}
