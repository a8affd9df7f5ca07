//! A ball in triangles with the ball's normals, and the start of its shadow rays.
//!
//! The triangles lie inside the ball. Where it turns away from the light, some of them face away
//! from the light before the ball's normal does: the shadow terminator problem.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Triangle, World};
use a04_lab::mesh::Mesh;
use common::{Color, Error};

use a06_shadows_reflection::secondary_ray;

/// Triangles, each with its corners as its surface.
pub type CoarseBall = World<[Point3; 3]>;

/// A ball of radius 1 around the origin in 20 · 4^`divisions` triangles.
pub fn coarse_ball(divisions: u32, background: Color) -> Result<CoarseBall, Error> {
    let mesh = Mesh::icosphere(divisions);
    let mut ball = World::new(background)?;
    for face in &mesh.faces {
        let vectors = face.map(|corner| mesh.corners[corner]);
        let [a, b, c] = vectors.map(|vector| Point3::ORIGIN + vector);
        let normals = vectors.map(Vector3::as_normal);
        let triangle = Triangle::new(a, b, c)?.with_normals(normals)?;
        ball = ball.with(triangle, [a, b, c]);
    }
    Ok(ball)
}

/// A rule for the shadow ray of a hit on a triangle with these corners.
pub type Start = fn(&Ray, &Hit, &[Point3; 3], Vector3) -> Ray;

/// The lesson's rule: from the triangle, offset by the bound of the rounding error.
pub const ON_THE_TRIANGLE: Start = |ray, hit, _, to_light| secondary_ray(ray, hit, to_light);

/// The rule of Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II (2021), chapter 4:
/// from the mean of the nearest points on the tangent planes of the three corners. A point that
/// lies above one of these planes stays there.
pub const ON_THE_CURVED_SURFACE: Start = |ray, hit, corners, to_light| {
    let p = ray.at(hit.t);
    let mut vector = Vector3::default();
    for (corner, weight) in corners.iter().zip(weights(corners, p)) {
        // The normal of the ball at a corner, which is 1 away from its centre.
        let normal = (*corner - Point3::ORIGIN).as_normal();
        let depth = (*corner - p).dot(normal);
        vector = vector + normal * (weight * depth.max(0.0));
    }
    // At a corner the start is on the triangle, and is offset as by the lesson, outwards.
    let outwards = secondary_ray(ray, hit, hit.geometric_normal.into());
    Ray::derived(outwards.origin() + vector, to_light)
};

/// The barycentric coordinates of a point of a triangle.
fn weights(&[a, b, c]: &[Point3; 3], p: Point3) -> [f64; 3] {
    let n = (b - a).cross(c - a);
    let beta = (p - a).cross(c - a).dot(n) / n.dot(n);
    let gamma = (b - a).cross(p - a).dot(n) / n.dot(n);
    [1.0 - beta - gamma, beta, gamma]
}
