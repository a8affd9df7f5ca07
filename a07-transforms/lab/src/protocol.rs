//! The formulas of the protocol as it prints them, mistakes included. They
//! are only for comparison, and to render pictures of the mistakes.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

use a07_transforms::{Mat4x4, Transform};

/// A matrix and its inverse by the protocol.
#[derive(Clone, Copy, Debug)]
pub struct Chained {
    pub m: Mat4x4,
    pub i: Mat4x4,
}

impl Chained {
    pub const IDENTITY: Self = Self {
        m: Mat4x4::IDENTITY,
        i: Mat4x4::IDENTITY,
    };

    /// Wrong: the inverse of a product has the inverses in the opposite order,
    /// but both are multiplied from the right, `i' = i T⁻¹`.
    #[must_use]
    pub fn then(self, step: &Transform) -> Self {
        Self {
            m: self.m * step.matrix(),
            i: self.i * step.inverse(),
        }
    }
}

/// Wrong: the text only "transposes" the matrix for a normal, which is the inverse
/// rotation.
pub fn transposed_normal(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    normal_as_vector(m.transposed(), n)
}

/// Wrong: transformed like a vector, a normal of a scaled object is no longer
/// perpendicular.
pub fn normal_as_vector(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    (m * Vector3::from(n)).normalized().map(Vector3::as_normal)
}

/// Wrong: with a fourth coordinate of 1 instead of 0, a normal is also translated.
pub fn normal_as_point(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    let moved = m * Point3::from_glam(n.to_glam()) - Point3::ORIGIN;
    moved.normalized().map(Vector3::as_normal)
}

/// Wrong: without length 1, a normal makes the surface darker or brighter.
pub fn unnormalized_normal(i: Mat4x4, n: Normal3) -> Vector3 {
    i.transposed() * Vector3::from(n)
}

/// Wrong: the program writes the translation into the last row, so that the product
/// with a point ignores it.
pub fn translation_in_last_row(translation: &Transform) -> Mat4x4 {
    translation.matrix().transposed()
}

/// Wrong: the product of the program exchanges rows and columns, and so the order
/// of its factors.
pub fn product(a: Mat4x4, b: Mat4x4) -> Mat4x4 {
    (a.transposed() * b.transposed()).transposed()
}

/// Wrong: the rule of Sarrus, diagonals down minus diagonals up, is valid for three
/// rows and columns only; for four it leaves out 16 of 24 products.
pub fn determinant_by_sarrus(rows: [[f64; 4]; 4]) -> f64 {
    let mut determinant = 0.0;
    for first in 0..4 {
        let (mut down, mut up) = (1.0, 1.0);
        for (i, row) in rows.iter().enumerate() {
            down *= row[(first + i) % 4];
            up *= row[(first + 4 - i) % 4];
        }
        determinant += down - up;
    }
    determinant
}

/// Wrong: without an `else`, the second condition overwrites the nearest hit, so
/// that the last hit in the list is returned.
pub fn last_hit(children: &[Box<dyn Geometry>], ray: &Ray) -> Option<Hit> {
    let mut cached: Option<Hit> = None;
    for child in children {
        let current = child.hit(ray, Interval::AHEAD);
        if matches!((current, cached), (Some(current), Some(nearest)) if current.t < nearest.t) {
            cached = current;
        }
        if current.is_some() {
            cached = current;
        }
    }
    cached
}

/// Wrong: rounding of the root moves the rim, and `<` excludes it; every radius is
/// accepted; and all `t` above 0 count, also for rays that leave the disc.
pub fn disc(a: Point3, n: Normal3, radius: f64, ray: &Ray) -> Option<f64> {
    if ray.direction().dot(n) == 0.0 {
        return None;
    }
    let t = (a - ray.origin()).dot(n) / ray.direction().dot(n);
    let from_centre = (a - ray.at(t)).magnitude();
    let inside = libm::pow(from_centre, 2.0) < libm::pow(radius, 2.0);
    (inside && t > 0.0).then_some(t)
}
