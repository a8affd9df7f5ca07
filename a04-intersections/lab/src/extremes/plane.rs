//! Rays that leave a plane. Grazing rays and far planes are rows of `cases.toml`.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::extremes::{AgainstProtocol, count_wrong};

use super::EPSILON;
use crate::protocol;
use crate::support::Numbers;
use a04_intersections::{Geometry, Interval, Plane};

/// Rays that start at hits of a slanted plane. Rounding moves the point to one of
/// its sides. With `t > 0` some rays hit the same plane again; with an interval
/// that begins after a few rounding errors of the lengths, no ray does.
pub fn leaving(count: usize) -> Result<AgainstProtocol<usize>, ArgumentError> {
    count_wrong(0..count, |n| {
        let mut numbers = Numbers::new(31, n);
        let normal = numbers.perpendicular()[0].as_normal();
        let plane = Plane::new(Point3::ORIGIN, normal)?;
        let eye = Point3::ORIGIN + numbers.triple(-5.0, 5.0);
        let ray = Ray::new(eye, numbers.direction())?;
        let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
            return Ok(AgainstProtocol::default());
        };
        let away = Ray::new(ray.at(hit.t), (-ray.direction()).reflected_on(normal))?;
        // A slanted ray hits the plane at a distance of the error over the cosine.
        let rounding = 64.0 * EPSILON * eye.largest_coordinate().max(hit.t);
        let within = Interval {
            min: rounding / away.direction().dot(normal).abs(),
            ..Interval::AHEAD
        };
        Ok(AgainstProtocol {
            ours: plane.hit(&away, within).is_some(),
            theirs: protocol::plane(Point3::ORIGIN, normal, &away).is_some(),
        })
    })
}
