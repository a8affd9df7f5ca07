//! Discs anywhere, met on both sides of the rim, from both sides, and behind the ray.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Plane};
use a06_shadows_reflection::Reflective;
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::steps::{expect_scene, frame, lit_from, point};

/// Rounding errors of coordinates up to 20.
const BOUND: Bound = Bound::Absolute(1e-10);

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3, f64) -> Result<G, ArgumentError>,
) {
    let mut random = Random::new(74);
    let up = Normal3::new(0.0, 1.0, 0.0);
    if let Ok(disc) = new(Point3::ORIGIN, up, 2.0) {
        // Whole numbers: exactly the rim.
        for (kind, x, exact) in [
            ("the middle", 0.0, Some(3.0)),
            ("exactly the rim", 2.0, Some(3.0)),
        ] {
            let ray = Ray::derived(Point3::new(x, 3.0, 0.0), Vector3::new(0.0, -1.0, 0.0));
            let got = disc.hit(&ray, Interval::AHEAD).map(|hit| hit.t);
            check.expect(
                format!("t, {kind}; disc around [0, 0, 0] of radius 2, from above"),
                exact,
                BOUND,
                got,
            );
        }
    }
    for _ in 0..20 {
        let (c, r, [n, side, other]) = (
            point(&mut random, 5.0),
            random.between(0.2, 4.0),
            frame(&mut random),
        );
        let Ok(disc) = new(c, n.as_normal() * random.between(0.2, 4.0), r) else {
            continue;
        };
        let turn = random.between(-3.0, 3.0);
        let (sin, cos) = libm::sincos(turn);
        let out = side * cos + other * sin;
        let mut at = |kind: &str, share: f64, height: f64, is_hit: bool| {
            let p = c + out * (share * r);
            let from = p + n * height + side * random.between(-2.0, 2.0);
            let ray = Ray::derived(from, (p - from) * 0.5);
            let got = disc.hit(&ray, Interval::AHEAD);
            let words = format!(
                "disc around {} of radius {r} with normal {:.2}, ray from {:.2} along {:.2}",
                c.to_glam(),
                n.to_glam(),
                from.to_glam(),
                ray.direction().to_glam()
            );
            let exact = is_hit.then_some(2.0);
            check.expect(
                format!("t, {kind}; {words}"),
                exact,
                BOUND,
                got.map(|hit| hit.t),
            );
            if let (Some(hit), true) = (got, is_hit) {
                let [exact, got] = [n.as_normal(), hit.normal].map(|n| n.to_glam().to_array());
                check.expect(format!("the normal, {kind}; {words}"), exact, BOUND, got);
            }
            let before = disc.hit(&ray, Interval::before(1.9)).map(|hit| hit.t);
            let what = format!("t, {kind}, but the interval ends before; {words}");
            check.expect(what, None::<f64>, BOUND, before);
            let away = disc
                .hit(&Ray::derived(from, from - p), Interval::AHEAD)
                .map(|hit| hit.t);
            check.expect(
                format!("t, {kind}, but behind the ray; {words}"),
                None::<f64>,
                BOUND,
                away,
            );
        };
        at("in the middle", 0.0, 2.0, true);
        at("in the middle, from the far side", 0.0, -2.0, true);
        at("just inside the rim", 1.0 - 1e-6, 3.0, true);
        at("just outside the rim", 1.0 + 1e-6, 3.0, false);
        at(
            "just outside the rim, from the far side",
            1.0 + 1e-6,
            -3.0,
            false,
        );
        at("far outside", 3.0, 1.0, false);
    }
    expect_scene(check, "disc", 8.0, || {
        let half = Color::gray(0.5);
        let red = Reflective::new(Color::RED, Color::BLACK, 64.0, half)?;
        let green = Reflective::new(Color::GREEN, Color::WHITE, 2000.0, half)?;
        let disc = new(Point3::new(0.0, 0.001, 0.0), up, 5.0)?;
        Ok(lit_from(Point3::new(8.0, 8.0, 8.0), true, 0.1)?
            .with(Plane::new(Point3::ORIGIN, up)?, Box::new(red))
            .with(disc, Box::new(green)))
    });
}
