//! Rays aimed at both rims of many rings, and a little inside and outside of them.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, show};

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3, f64, f64) -> Result<G, ArgumentError>,
) {
    // Both borders belong to the ring: points whose distance is whole.
    let c = Point3::new(1.0, 2.0, 3.0);
    if let Ok(ring) = new(c, Normal3::new(0.0, 1.0, 0.0), 5.0, 13.0) {
        for (x, z) in [(3.0, 4.0), (-5.0, 0.0), (5.0, -12.0), (0.0, 13.0)] {
            let ray = Ray::derived(c + Vector3::new(x, 4.0, z), Vector3::new(0.0, -2.0, 0.0));
            let got = ring.hit(&ray, Interval::AHEAD).map(|hit| hit.t);
            let distance = libm::hypot(x, z);
            let what = format!(
                "t at the distance {distance}, over ({x}, {z}), ring from 5 to 13 around [1, 2, 3], both included"
            );
            check.expect(what, Some(2.0), Bound::Absolute(1e-13), got);
        }
    }
    // Perpendicular to each other, all of length 1.
    let n = Vector3::new(0.48, 0.6, 0.64);
    let (u, v) = (Vector3::new(0.8, 0.0, -0.6), Vector3::new(0.36, -0.8, 0.48));
    let (tilted, level) = ([n, u, v], [v, n, u]);
    // A normal of length 2 makes no larger ring.
    expect_ring(check, &new, Point3::new(3.0, -1.0, 2.0), tilted, [0.5, 2.0]);
    let mut random = Random::new(1);
    for axes in [tilted, level].into_iter().cycle().take(6) {
        let [x, y, z] = [(); 3].map(|()| random.between(-9.0, 9.0));
        let hole = random.between(0.1, 4.0);
        let rims = [hole, hole + random.between(0.1, 6.0)];
        expect_ring(check, &new, Point3::new(x, y, z), axes, rims);
    }

    let saturn = || {
        let tilted = Normal3::new(0.3, 1.0, 0.1);
        let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
        Ok(World::new(Color::gray(0.05))?
            .with(ball, Color::new(0.9, 0.75, 0.5))
            .with(new(Point3::ORIGIN, tilted, 1.3, 2.2)?, Color::gray(0.8)))
    };
    show(check, saturn(), Point3::new(1.0, 2.0, 6.0), Point3::ORIGIN);
}

/// Rays to a ring around its first axis, with the radii of hole and rim.
fn expect_ring<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3, f64, f64) -> Result<G, ArgumentError>,
    c: Point3,
    [n, u, v]: [Vector3; 3],
    [hole, r]: [f64; 2],
) {
    let Ok(ring) = new(c, (n * 2.0).as_normal(), hole, r) else {
        return;
    };
    let name = format!("ring from {hole} to {r} around {}", c.to_glam());
    for (sin, cos) in TURNS {
        for (distance, is_hit) in [
            (0.0, false),
            (0.8 * hole, false),
            (hole - 1e-9, false),
            (hole + 1e-9, true),
            (f64::midpoint(hole, r), true),
            (r - 1e-9, true),
            (r + 1e-9, false),
            (1.5 * r, false),
        ] {
            let at = c + u * (cos * distance) + v * (sin * distance);
            for from in [at + n * 2.0 + u, at - n * 3.0 + v] {
                let got = ring.hit(&Ray::derived(from, at - from), Interval::AHEAD);
                let what = format!(
                    "t at the distance {distance:.9}, from {:.3}, {name}",
                    from.to_glam()
                );
                let exact = is_hit.then_some(1.0);
                check.expect(what, exact, Bound::Absolute(1e-12), got.map(|hit| hit.t));
                if let (true, Some(hit)) = (is_hit, got) {
                    let across = hit.normal.dot(n).abs();
                    let what = format!("the cosine between normal and axis, {name}");
                    check.expect(what, 1.0, Bound::Absolute(1e-13), across);
                }
            }
        }
    }
    let at = c + u * f64::midpoint(hole, r);
    for (from, within, place) in [
        (
            at + n * 2.0,
            Interval::before(1.9),
            "the interval ends before it",
        ),
        (at - n * 2.0, Interval::AHEAD, "away from it"),
        (
            at + n * 2.0,
            Interval { min: 2.1, max: 9.0 },
            "the interval begins behind it",
        ),
    ] {
        let got = ring.hit(&Ray::derived(from, -n), within).map(|hit| hit.t);
        let what = format!("t, {place}, {name}");
        check.expect(what, None::<f64>, Bound::Equal, got);
    }
}
