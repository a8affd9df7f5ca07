//! Rays that pass a sphere a millionth of its radius inside or outside of its
//! border, behind it, and from within.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::shape::{TURNS, turned};

pub fn check(check: &mut Check, may_meet: impl Fn(Point3, f64, &Ray) -> bool) {
    let (c, r) = (Point3::new(3.0, -1.0, 2.0), 2.0);
    for turn in TURNS {
        // Perpendicular to each other.
        let ahead = turned(turn, 0.0, 0.0, 1.0);
        let aside = turned(turn, 0.6, 0.8, 0.0);
        for length in [1.0, 0.001, 1000.0] {
            let mut passing = |beside: f64, along: f64, exact: bool| {
                let origin = c + aside * (r * beside) + ahead * (r * along);
                let got = may_meet(c, r, &Ray::derived(origin, ahead * length));
                let what = format!(
                    "from {along} radii along the ray, {beside} beside, direction of length {length}"
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
        }
    }
    let at_centre = Ray::derived(c, Vector3::new(0.0, 1.0, 0.0));
    let got = may_meet(c, r, &at_centre);
    check.expect("from the centre itself", true, Bound::Equal, got);
}
