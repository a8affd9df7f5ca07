//! Rims, radii and grazing rays.

use std::f64::consts::SQRT_2;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::lab::extremes::{Line, first};
use a04_intersections::{Geometry, Hit, Interval};
use a06_shadows_reflection::secondary_ray;
use measure::Effort;
use measure::extremes::{
    Case, Equal, Fails, Holds, Nothing, Outcome, Protocol, Refused, Ulps, tried,
};

use super::raw_ray;
use crate::{Disc, protocol};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

/// The `t` at which a ray hits the disc around the origin.
fn hit(
    id: &'static str,
    what: &str,
    r: f64,
    line: Line,
    exact: impl Into<Outcome>,
    says: Protocol,
) -> Case {
    let ray = raw_ray(line);
    let ours = Disc::new(Point3::ORIGIN, UP, r).map(|disc| first(&disc, &ray));
    Case::new(id, format!("disc, {what}"), exact, Ulps(1.0), ours)
        .protocol(says, protocol::disc(Point3::ORIGIN, UP, r, &ray))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let from = |x, z| ([x, 1.0, z], [0.0, -1.0, 0.0]);
    let above = from(0.0, 0.0);
    vec![
        hit("B12", "the rim, |p| = r = 5", 5.0, from(3.0, 4.0), 1.0, Fails),
        hit("B13", "|p|² = 2, r = √2 of which the square is 2 + 2^-51", SQRT_2, from(1.0, 1.0), 1.0, Fails),
        hit("B14", "one unit in the last place outside of the rim",
            5.0, from(3.0, 4.0_f64.next_up()), Nothing, Holds),
        hit("B15", "r = -2", -2.0, above, Refused, Fails),
        hit("B16", "r = 1e-170, whose square is 0", 1e-170, above, Refused, Fails),
        hit("B17", "grazing, through the centre", 1.0, ([-1.0, 1e-16, 0.0], [1.0, -1e-16, 0.0]), 1.0, Holds),
        hit("B18", "a ray within the plane of the disc",
            1.0, ([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Nothing, Holds),
        hit("B31", "a slope of 5e-324, t beyond all numbers",
            1.0, ([0.0, 1.0, 0.0], [1.0, -5e-324, 0.0]), Nothing, Holds),
        hit("B32", "r = NaN", f64::NAN, above, Refused, Fails),
        hit("B33", "r = infinity", f64::INFINITY, above, Refused, Fails),
        leaving("B34", effort.choose(2_000, 20_000)),
    ]
}

/// Rays that leave a disc on the side from which it was hit must not hit it again.
fn leaving(id: &'static str, count: usize) -> Case {
    let (c, n, r) = (Point3::new(0.1, 0.2, 0.3), Normal3::new(0.3, 1.0, 0.2), 1.0);
    let met_again = |is_met: &dyn Fn(&Disc, Normal3, &Ray, &Hit) -> bool| {
        tried(|| {
            let (n, disc) = (n.unit("normal n")?, Disc::new(c, n, r)?);
            let is_wrong = |i: &usize| {
                let random = PixelRandom::new(18, *i as u32, 0);
                let number = |n| random.uniform(n) - 0.5;
                let eye = Point3::new(4.0, 5.0, 3.0);
                let target = c + Vector3::new(number(0), number(1) / 9.0, number(2));
                Ray::new(eye, target - eye).is_ok_and(|ray| {
                    let hit = disc.hit(&ray, Interval::AHEAD);
                    hit.is_some_and(|hit| is_met(&disc, n, &ray, &hit))
                })
            };
            Ok((0..count).filter(is_wrong).count())
        })
    };
    let ours = met_again(&|disc, n, ray, hit| {
        let away = secondary_ray(ray, hit, Vector3::from(n));
        first(disc, &away).is_some()
    });
    let theirs = met_again(&|_, n, ray, hit| {
        let away = Ray::derived(ray.at(hit.t), Vector3::from(n));
        protocol::disc(c, n, r, &away).is_some()
    });
    let what = format!("disc, {count} rays that leave it: met again");
    Case::new(id, what, 0.0, Equal, ours).protocol(Fails, theirs)
}
