//! Points of rays of hundredths, and points beside them.

use a02_math::Point3;
use a03_rays_cameras::{Ray, StripeRule, render};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::sky::{camera, expect_scene, frame, point, triple};

/// Some roundings of coordinates up to 100.
const BOUND: Bound = Bound::Absolute(1e-11);

pub fn check(
    check: &mut Check,
    at: impl Fn(&Ray, f64) -> Point3 + Sync,
    t_of: impl Fn(&Ray, Point3) -> f64 + Sync,
) {
    let mut random = Random::new(31);
    for steps in [0.0, 1.0, 2.5, -3.0, 0.5, 7.0, -1.0, 4.0] {
        let [d, side, _] = frame(&mut random);
        let (o, length) = (point(&mut random), random.between(0.1, 4.0));
        let ray = Ray::derived(o, d * length);
        let exact = o + d * (length * steps);
        let way = |p: Point3| triple(p - Point3::ORIGIN);
        let words = format!(
            "ray from {} along {:.3}",
            o.to_glam(),
            ray.direction().to_glam()
        );
        let what = format!("the point; {words}, t = {steps}");
        check.expect(what, way(exact), BOUND, way(at(&ray, steps)));
        for (kind, p) in [
            ("on the ray", exact),
            ("beside the ray", exact + side * 2.0),
        ] {
            let what = format!("t of a point {kind}; {words}, point {:.3}", p.to_glam());
            check.expect(what, steps, BOUND, t_of(&ray, p));
        }
    }
    expect_scene(check, StripeRule::Direction, |settings, sky| {
        // To a point seven steps away, and the view of the eye from there.
        let radiance = |ray: &Ray| {
            let point = at(ray, t_of(ray, ray.at(7.0)));
            sky.color_for(&Ray::derived(
                ray.origin(),
                (point - ray.origin()) * (1.0 / 7.0),
            ))
        };
        render(&camera()?, radiance, settings, &())
    });
}
