//! Planes at grazing angles, far planes, and rays that leave a plane.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::{Absolute, Equal, Fails, Holds, Ulps};
use measure::extremes::{Both, Case, case, wrong};

use super::{EPSILON, MISS, REFUSED, meeting};
use crate::protocol;
use crate::subject::PLANE;
use crate::support::{Line, Numbers, Triple, first, raw_ray, vector};
use a04_intersections::{Geometry, Interval, Plane};

const UP: Triple = [0.0, 1.0, 0.0];

/// The first hit of a plane, by our formula and by the protocol's.
fn met((a, n): (Triple, Triple), line: Line) -> Both {
    PLANE.met(&[a, n].concat(), line)
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let ground = ([0.0; 3], UP);
    let eye = |y: f64, d: Triple| ([0.0, y, 0.0], d);
    let down = [0.0, -1.0, 0.0];
    let at = |y: f64| ([0.0, y, 0.0], UP);
    let n = [1.0, 2.0, 3.0].map(|x: f64| x / 14.0_f64.sqrt());
    let away = ([3e6, 0.0, -1e6], [1.0, 2.0, 3.0]);
    // The product of two lengths of 1e-200 is 0, so the protocol finds no plane.
    let (tiny, short) = (vector([0.0, 1e-200, 0.0]).as_normal(), eye(1.0, [0.0, -1e-200, 0.0]));
    let of_tiny = protocol::plane(Point3::ORIGIN, tiny, &raw_ray(short)).map(|t| t * 1e-200);
    let (from_infinity, up) = (raw_ray(eye(f64::INFINITY, down)), vector(UP).as_normal());
    vec![
        case("B01", "grazing, slope 1e-15",
            met(ground, eye(1.0, [1.0, -1e-15, 0.0])), 999_999_999_999_999.9, Ulps(1.0), Holds),
        case("B02", "grazing, with the least slope there is: t would be infinite",
            met(ground, eye(1.0, [1.0, -5e-324, 0.0])), MISS, Equal, Fails),
        case("B03", "parallel, with terms that cancel",
            met(([0.0; 3], [0.3, 0.5, 0.7]), eye(1.0, [0.5, -0.3, 0.0])), MISS, Equal, Holds),
        case("B04", "the plane's point is 3e6 away within it",
            met(away, (n.map(|x| 5.0 * x), n.map(|x| -x))), 5.0, Absolute(4.0 * EPSILON * 3.17e6), Holds),
        case("B05", "from a point of the plane", met(ground, ([3.0, 0.0, 4.0], down)), MISS, Equal, Holds),
        case("B20", "within the plane: 0 divided by 0",
            met(ground, ([3.0, 0.0, 4.0], [1.0, 0.0, 0.0])), MISS, Equal, Holds),
        case("B06", "parallel, with a cosine of negative 0",
            met(ground, eye(1.0, [1.0, -0.0, 0.0])), MISS, Equal, Holds),
        Case::new("B07", "normal and direction of length 1e-200: the distance",
            1.0, Equal, meeting(Plane::new(Point3::ORIGIN, tiny), short)).protocol(Fails, of_tiny),
        case("B08", "1 above the plane at 1e15", met(at(1e15), eye(1e15 + 1.0, down)), 1.0, Equal, Holds),
        case("B09", "1 above the plane at 1e16, where doubles are 2 apart: on it",
            met(at(1e16), eye(1e16 + 1.0, down)), MISS, Equal, Holds),
        case("B10", "a normal of NaN", met(([0.0; 3], [f64::NAN, 1.0, 0.0]), eye(1.0, down)), REFUSED, Equal, Fails),
        Case::new("B11", "an infinite origin, past the constructor", MISS, Equal,
            Plane::new(Point3::ORIGIN, up).map(|plane| first(&plane, &from_infinity)))
            .protocol(Fails, protocol::plane(Point3::ORIGIN, up, &from_infinity)),
        Case::wrong("B19", "reflected rays that meet the plane that they leave once more", leaving(effort)),
    ]
}

/// Rays that start at hits of a slanted plane. Rounding moves the point to one of
/// its sides. With `t > 0` some rays hit the same plane again; with an interval
/// that begins after a few rounding errors of the lengths, no ray does.
fn leaving(effort: Effort) -> Result<[usize; 2], ArgumentError> {
    wrong(0..effort.choose(1000, 20_000), |n| {
        let mut numbers = Numbers::new(31, n);
        let normal = numbers.perpendicular()[0].as_normal();
        let plane = Plane::new(Point3::ORIGIN, normal)?;
        let eye = Point3::ORIGIN + numbers.triple(-5.0, 5.0);
        let ray = Ray::new(eye, numbers.direction())?;
        let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
            return Ok([false; 2]);
        };
        let away = Ray::new(ray.at(hit.t), (-ray.direction()).reflected_on(normal))?;
        // A slanted ray hits the plane at a distance of the error over the cosine.
        let rounding = 64.0 * EPSILON * eye.largest_coordinate().max(hit.t);
        let within = Interval {
            min: rounding / away.direction().dot(normal).abs(),
            ..Interval::AHEAD
        };
        let theirs = protocol::plane(Point3::ORIGIN, normal, &away);
        Ok([plane.hit(&away, within).is_some(), theirs.is_some()])
    })
}
