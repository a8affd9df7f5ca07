//! The weights of a triangle's corners at a point, and the normal between theirs.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Triangle};

use super::{Answered, point};
use crate::Reply;

/// How far the normals of the corners lean outwards.
const LEAN: f64 = 1.0;

/// Numbers: the corners a, b and c, and the point under the ray, which comes from
/// above. The normals of the corners lean away from the middle of the triangle.
pub fn answer([ax, ay, bx, by, cx, cy, x, y]: [f64; 8]) -> Answered {
    let corners = [point(ax, ay), point(bx, by), point(cx, cy)];
    let ray = Ray::new(Point3::new(x, y, 1.0), Vector3::new(0.0, 0.0, -1.0))?;
    let [a, b, c] = corners;
    let triangle = Triangle::new(a, b, c)?;
    let shaded = |normals| -> Result<_, common::ArgumentError> {
        let hit = triangle.with_normals(normals)?.hit(&ray, Interval::AHEAD);
        Ok(hit.map(|hit| Vector3::from(hit.normal).to_glam().to_array()))
    };
    // With the axes as normals the coordinates are the weights, normalised.
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let weights = shaded(axes.map(|axis| Normal3::from_glam(axis.into())))?.map(|lengths| {
        let sum: f64 = lengths.iter().sum();
        lengths.map(|length| length / sum)
    });
    let middle = point((ax + bx + cx) / 3.0, (ay + by + cy) / 3.0);
    let normal = shaded(corners.map(|corner| {
        let upwards = Vector3::new(0.0, 0.0, 1.0);
        (upwards + (corner - middle) * LEAN).as_normal()
    }))?;
    Ok(Reply::default()
        .with("weights", weights.into_iter().flatten())
        .with("normal", normal.into_iter().flatten()))
}
