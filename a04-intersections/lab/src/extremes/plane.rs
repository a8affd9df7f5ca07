//! Planes and rays of tiny lengths, and rays that leave a plane. Grazing rays and far planes are rows
//! of `cases.toml`.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::{Both, Case, Fails, Known, Number, count_wrong};

use super::{EPSILON, meeting};
use crate::line::{Line, line};
use crate::protocol;
use crate::support::{Numbers, Triple, vector};
use a04_intersections::{Geometry, Interval, Plane};

/// The line from a height above the origin.
fn eye(height: f64, direction: Triple) -> Line {
    line([0.0, height, 0.0], direction)
}

/// The plane y = 0 and a ray, both of lengths of 1e-200, whose product is 0, so that the protocol
/// finds no plane. A row of `cases.toml` gives the protocol's formula a normal of length 1.
fn of_tiny_lengths() -> Case {
    let normal = vector([0.0, 1e-200, 0.0]).as_normal();
    let short = eye(1.0, [0.0, -1e-200, 0.0]);
    let theirs = protocol::plane(Point3::ORIGIN, normal, &short.raw_ray());
    let ours = meeting(Plane::new(Point3::ORIGIN, normal), short);
    Case::of(ours, theirs.map(|t| t * 1e-200))
}

pub fn cases(effort: Effort) -> Vec<Case> {
    vec![
        Case {
            id: "B07".into(),
            what: "normal and direction of length 1e-200: the distance".into(),
            exact: Number(1.0),
            condition: Known(2.0),
            protocol: Fails,
            ..of_tiny_lengths()
        },
        Case::of_wrong(
            "B19",
            "reflected rays that meet the plane that they leave once more",
            leaving(effort),
        ),
    ]
}

/// Rays that start at hits of a slanted plane. Rounding moves the point to one of
/// its sides. With `t > 0` some rays hit the same plane again; with an interval
/// that begins after a few rounding errors of the lengths, no ray does.
fn leaving(effort: Effort) -> Result<Both<usize>, ArgumentError> {
    count_wrong(0..effort.choose(1000, 20_000), |n| {
        let mut numbers = Numbers::new(31, n);
        let normal = numbers.perpendicular()[0].as_normal();
        let plane = Plane::new(Point3::ORIGIN, normal)?;
        let eye = Point3::ORIGIN + numbers.triple(-5.0, 5.0);
        let ray = Ray::new(eye, numbers.direction())?;
        let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
            return Ok(Both::default());
        };
        let away = Ray::new(ray.at(hit.t), (-ray.direction()).reflected_on(normal))?;
        // A slanted ray hits the plane at a distance of the error over the cosine.
        let rounding = 64.0 * EPSILON * eye.largest_coordinate().max(hit.t);
        let within = Interval {
            min: rounding / away.direction().dot(normal).abs(),
            ..Interval::AHEAD
        };
        Ok(Both {
            ours: plane.hit(&away, within).is_some(),
            theirs: protocol::plane(Point3::ORIGIN, normal, &away).is_some(),
        })
    })
}
