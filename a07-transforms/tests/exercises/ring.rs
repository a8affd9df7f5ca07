//! Rays aimed a little inside and outside of both rims of a ring.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::shape::{TURNS, show};

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3, f64, f64) -> Result<G, ArgumentError>,
) {
    let c = Point3::new(3.0, -1.0, 2.0);
    // Perpendicular to each other, all of length 1.
    let n = Vector3::new(0.48, 0.6, 0.64);
    let (u, v) = (Vector3::new(0.8, 0.0, -0.6), Vector3::new(0.36, -0.8, 0.48));
    // A normal of length 2 makes no larger ring.
    let Ok(ring) = new(c, (n * 2.0).as_normal(), 0.5, 2.0) else {
        return;
    };
    for (sin, cos) in TURNS {
        for (distance, is_hit) in [
            (0.0, false),
            (0.4, false),
            (0.5 - 1e-9, false),
            (0.5 + 1e-9, true),
            (1.2, true),
            (2.0 - 1e-9, true),
            (2.0 + 1e-9, false),
            (3.0, false),
        ] {
            let at = c + u * (cos * distance) + v * (sin * distance);
            for from in [at + n * 2.0 + u, at - n * 3.0 + v] {
                let got = ring.hit(&Ray::derived(from, at - from), Interval::AHEAD);
                let what = format!("t at the distance {distance}, to {}", at.to_glam());
                let exact = is_hit.then_some(1.0);
                check.expect(what, exact, Bound::Absolute(1e-13), got.map(|hit| hit.t));
                if let (true, Some(hit)) = (is_hit, got) {
                    let across = hit.normal.dot(n).abs();
                    let what = "the cosine between normal and axis";
                    check.expect(what, 1.0, Bound::Absolute(1e-13), across);
                }
            }
        }
    }
    let ray = Ray::derived(c + u + n * 2.0, -n);
    let early = ring.hit(&ray, Interval::before(1.9)).map(|hit| hit.t);
    let what = "t, as the interval ends before the ring";
    check.expect(what, None::<f64>, Bound::Equal, early);

    let saturn = || {
        let tilted = Normal3::new(0.3, 1.0, 0.1);
        let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
        Ok(World::new(Color::gray(0.05))?
            .with(ball, Color::new(0.9, 0.75, 0.5))
            .with(new(Point3::ORIGIN, tilted, 1.3, 2.2)?, Color::gray(0.8)))
    };
    show(check, saturn(), Point3::new(1.0, 2.0, 6.0), Point3::ORIGIN);
}
