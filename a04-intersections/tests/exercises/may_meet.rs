//! Rays that pass a sphere a millionth of its radius inside or outside of its
//! border, behind it, from within, and just along it.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, turned};

pub fn check(check: &mut Check, may_meet: impl Fn(Point3, f64, &Ray) -> bool) {
    let mut random = Random::new(2);
    for (n, turn) in (0..).zip(TURNS) {
        let c = match n {
            0 => Point3::ORIGIN,
            _ => Point3::new(3.0, -1.0, 2.0) + turned(turn, f64::from(n), 0.0, 1.0),
        };
        let r = [1.0, 2.0, 0.3, 7.5][n as usize % 4];
        // Perpendicular to each other.
        let ahead = turned(turn, 0.0, 0.0, 1.0);
        let aside = turned(turn, 0.6, 0.8, 0.0);
        for length in [1.0, 0.001, 1000.0] {
            let mut passing = |beside: f64, along: f64, exact: bool| {
                let origin = c + aside * (r * beside) + ahead * (r * along);
                let got = may_meet(c, r, &Ray::derived(origin, ahead * length));
                let what = format!(
                    "from {along} radii along the ray, {beside} beside, radius {r}, direction of length {length}"
                );
                check.expect(what, exact, Bound::Equal, got);
            };
            passing(0.0, -5.0, true);
            passing(1.0 - 1e-6, -5.0, true);
            passing(1.0 + 1e-6, -5.0, false);
            passing(0.0, 1.1, false);
            // From inside, though the centre is behind.
            passing(0.5, 0.8, true);
            passing(0.0, 0.999, true);
            passing(0.8, 0.7, false);
            for _ in 0..10 {
                let (beside, along) = (random.between(-2.0, 2.0), random.between(-4.0, 2.0));
                let nearest = if along < 0.0 {
                    beside.abs()
                } else {
                    libm::hypot(beside, along)
                };
                if (nearest - 1.0).abs() > 1e-6 {
                    passing(beside, along, nearest < 1.0);
                }
            }
        }
    }
    let c = Point3::new(3.0, -1.0, 2.0);
    for (x, y, place) in [
        (0.0, 0.0, "from the centre itself"),
        (2.0, -5.0, "along the border, which counts as within"),
        (0.0, 2.0, "from the border, away from the sphere"),
    ] {
        let ray = Ray::derived(c + Vector3::new(x, y, 0.0), Vector3::new(0.0, 1.0, 0.0));
        check.expect(place, true, Bound::Equal, may_meet(c, 2.0, &ray));
    }
}
