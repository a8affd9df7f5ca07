//! Planes at grazing angles, far planes, and rays that leave a plane.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{
    EPSILON, Line, MISS, REFUSED, Triple, any_ray, first, meeting, point, raw_ray, vector,
};
use crate::lab::experiments::Numbers;
use crate::{Geometry, Interval, Plane, protocol};

const UP: Triple = [0.0, 1.0, 0.0];

fn case(
    id: &'static str,
    what: &str,
    (a, n): (Triple, Triple),
    line: Line,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let (a, n) = (point(a), vector(n).as_normal());
    // The protocol also normalises, except where its formula fails.
    let unit = n.normalized().unwrap_or(n);
    Case::new(id, what, exact, bound, meeting(Plane::new(a, n), line))
        .protocol(says, protocol::plane(a, unit, &any_ray(line)))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let ground = ([0.0; 3], UP);
    let eye = |y: f64, d: Triple| ([0.0, y, 0.0], d);
    let down = [0.0, -1.0, 0.0];
    let at = |y: f64| ([0.0, y, 0.0], UP);
    let n = [1.0, 2.0, 3.0].map(|x: f64| x / 14.0_f64.sqrt());
    let away = ([3e6, 0.0, -1e6], [1.0, 2.0, 3.0]);
    vec![
        case("B01", "grazing, slope 1e-15",
            ground, eye(1.0, [1.0, -1e-15, 0.0]), 999_999_999_999_999.9, Bound::Ulps(1.0), Holds),
        case("B02", "grazing, with the least slope there is: t would be infinite",
            ground, eye(1.0, [1.0, -5e-324, 0.0]), MISS, Bound::Equal, Fails),
        case("B03", "parallel, but for rounding: a distant t or none, no infinity",
            ([0.0; 3], [0.3, 0.5, 0.7]), eye(1.0, [0.5, -0.3, 0.0]), MISS, Bound::Finite, Holds),
        case("B04", "the plane's point is 3e6 away within it",
            away, (n.map(|x| 5.0 * x), n.map(|x| -x)),
            5.0, Bound::Absolute(4.0 * EPSILON * 3.17e6), Holds),
        case("B05", "from a point of the plane",
            ground, ([3.0, 0.0, 4.0], down), MISS, Bound::Equal, Holds),
        case("B06", "parallel, with a cosine of negative 0",
            ground, eye(1.0, [1.0, -0.0, 0.0]), MISS, Bound::Equal, Holds),
        tiny_lengths(),
        case("B08", "1 above the plane at 1e15",
            at(1e15), eye(1e15 + 1.0, down), 1.0, Bound::Equal, Holds),
        case("B09", "1 above the plane at 1e16, where doubles are 2 apart: on it",
            at(1e16), eye(1e16 + 1.0, down), MISS, Bound::Equal, Holds),
        case("B10", "a normal of NaN",
            ([0.0; 3], [f64::NAN, 1.0, 0.0]), eye(1.0, down), REFUSED, Bound::Equal, Fails),
        infinite_origin(),
        leaving(effort),
    ]
}

/// The product of two lengths of 1e-200 is 0, so the protocol finds no plane.
fn tiny_lengths() -> Case {
    let line = ([0.0, 1.0, 0.0], [0.0, -1e-200, 0.0]);
    let n = Normal3::new(0.0, 1e-200, 0.0);
    let raw = protocol::plane(Point3::ORIGIN, n, &raw_ray(line));
    let ours = meeting(Plane::new(Point3::ORIGIN, n), line);
    let what = "normal and direction of length 1e-200: the distance";
    Case::new("B07", what, 1.0, Bound::Equal, ours).protocol(Fails, raw.map(|t| t * 1e-200))
}

fn infinite_origin() -> Case {
    let ray = raw_ray(([0.0, f64::INFINITY, 0.0], [0.0, -1.0, 0.0]));
    let n = vector(UP).as_normal();
    let ours = Plane::new(Point3::ORIGIN, n).map(|plane| first(&plane, &ray));
    Case::new(
        "B11",
        "an infinite origin, past the constructor",
        MISS,
        Bound::Equal,
        ours,
    )
    .protocol(Fails, protocol::plane(Point3::ORIGIN, n, &ray))
}

/// Rays that start at hits of a slanted plane. Rounding moves the point to one of
/// its sides. With `t > 0` some rays hit the same plane again; with an interval
/// that begins after a few rounding errors of the lengths, no ray does.
fn leaving(effort: Effort) -> Case {
    let count = |again: &dyn Fn(Point3, Normal3, &Plane, &Ray, f64) -> bool| {
        let mut met = 0_usize;
        for n in 0..effort.choose(1000, 20_000) {
            let mut numbers = Numbers::new(31, n);
            let [normal, _] = numbers.perpendicular();
            let (a, normal) = (Point3::ORIGIN, normal.as_normal());
            let plane = Plane::new(a, normal)?;
            let eye = a + numbers.triple(-5.0, 5.0);
            let ray = Ray::new(eye, numbers.direction())?;
            let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
                continue;
            };
            let p = ray.at(hit.t);
            let away = (-ray.direction()).reflected_on(normal);
            let size = eye.largest_coordinate().max(hit.t);
            let onwards = Ray::new(p, away)?;
            met += usize::from(again(a, normal, &plane, &onwards, 64.0 * EPSILON * size));
        }
        Ok::<_, ArgumentError>(met)
    };
    // A slanted ray hits the plane at a distance of the error over the cosine.
    let ours = count(&|_, normal, plane, ray, least| {
        use a02_math::Direction;
        let min = least / ray.direction().dot(normal).abs();
        let within = Interval {
            min,
            ..Interval::AHEAD
        };
        plane.hit(ray, within).is_some()
    });
    let theirs = count(&|a, normal, _, ray, _| protocol::plane(a, normal, ray).is_some());
    let what = "reflected rays that meet the plane that they leave once more";
    Case::new("B19", what, 0.0, Bound::Equal, ours).protocol(Fails, theirs)
}
