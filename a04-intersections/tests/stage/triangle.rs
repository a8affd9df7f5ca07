//! Triangles: their borders, their two sides, and their normals.

mod degenerate;
mod hits;
mod in_plane;
mod normals;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Triangle};

const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);

fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

/// In the plane z = 0, counterclockwise seen from the front: its right angle at
/// the origin, and two legs of length 3.
fn triangle() -> Triangle {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    Triangle::new(a, b, c).unwrap()
}

/// From 4 in front of the place (`x`, `y`), straight ahead.
fn ahead(x: f64, y: f64) -> Ray {
    Ray::derived(point([x, y, 4.0]), Vector3::new(0.0, 0.0, -1.0))
}

fn hit(triangle: &Triangle, ray: &Ray) -> Option<Hit> {
    triangle.hit(ray, Interval::AHEAD)
}
