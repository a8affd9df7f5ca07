//! Spheres anywhere, met from outside, from inside, behind the ray, and along the rim.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::aimed::{Shown, alone, expect_scene, frame, point};

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, f64) -> Result<G, ArgumentError>,
) {
    let centre = Point3::new(0.0, 0.0, -3.0);
    if let Ok(sphere) = new(centre, 0.5) {
        let words = "sphere around [0, 0, -3] of radius 0.5".to_owned();
        let sphere = Shown {
            shape: &sphere,
            words,
        };
        let (d, n) = (Vector3::new(0.0, 0.0, -1.0), Normal3::new(0.0, 0.0, 1.0));
        let ray = Ray::derived(Point3::ORIGIN, d);
        sphere.expect(
            check,
            "straight ahead",
            &ray,
            Interval::AHEAD,
            Some((2.5, n)),
        );
    }
    let mut random = Random::new(41);
    for _ in 0..20 {
        let (c, r) = (point(&mut random, 5.0), random.between(0.2, 4.0));
        let Ok(sphere) = new(c, r) else { continue };
        let words = format!("sphere around {} of radius {r}", c.to_glam());
        let sphere = Shown {
            shape: &sphere,
            words,
        };

        let [n, side, _] = frame(&mut random);
        let at = c + n * r;
        let outside = at + n * random.between(0.5, 4.0) + side * random.between(-2.0, 2.0);
        let inside = c + side * (r * random.between(-0.9, 0.9));
        let normal = n.as_normal();
        sphere.expect_nearest(check, "from outside", outside, at, normal);
        sphere.expect_nearest(check, "from inside", inside, at, normal);
        sphere.expect_none(check, "the sphere lies behind", outside, outside - at);

        // The chord from `at` ends after -2 r (n · d) / (d · d) more steps.
        let ray = Ray::derived(outside, at - outside);
        let d = ray.direction();
        let far = 1.0 - 2.0 * r * n.dot(d) / d.dot(d);
        let out = (ray.at(far) - c) * (1.0 / r);
        let second = Interval {
            min: 1.0 + 1e-6,
            max: f64::INFINITY,
        };
        let exact = Some((far, out.as_normal()));
        sphere.expect(
            check,
            "the far side, as the interval begins after the near one",
            &ray,
            second,
            exact,
        );

        let past = |share: f64| at + n * (r * share) + side * 3.0;
        sphere.expect_none(check, "a millionth beside the rim", past(1e-6), -side);
        // r² - (r (1 - δ))² = r² δ (2 - δ)
        let half_chord = r * (1e-6_f64 * (2.0 - 1e-6)).sqrt();
        let exact = 3.0 - half_chord;
        let hit = sphere
            .shape
            .hit(&Ray::derived(past(-1e-6), -side), Interval::AHEAD);
        let words = &sphere.words;
        let what = format!("t, a millionth inside the rim; {words}");
        check.expect(
            what,
            exact,
            measure::extremes::Bound::Absolute(1e-6),
            hit.map(|hit| hit.t),
        );
    }
    expect_scene(check, "scene-2", || alone(new(centre, 0.5)?, Color::RED));
}
