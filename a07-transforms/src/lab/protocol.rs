//! The formulas of the protocol as it prints them, mistakes included. The
//! tables hold them against what is right, and only pictures of the mistakes
//! are rendered with them.

#![expect(
    clippy::must_use_candidate,
    reason = "for tables and pictures of mistakes"
)]

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

use crate::{Mat4x4, Transform};

/// A matrix and what the protocol takes for its inverse.
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

/// Wrong: by its word a normal is "transposed", which the rotation back does.
pub fn transposed_normal(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    let n = m.transposed() * Vector3::from(n);
    n.normalized().map(Vector3::as_normal)
}

/// Wrong: moved like a vector, a normal is no longer perpendicular where the
/// object is stretched.
pub fn normal_as_vector(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    (m * Vector3::from(n)).normalized().map(Vector3::as_normal)
}

/// Wrong: with a fourth coordinate of 1 instead of 0, a normal is also moved.
pub fn normal_as_point(m: Mat4x4, n: Normal3) -> Option<Normal3> {
    let moved = m * Point3::from_glam(n.to_glam());
    (moved - Point3::ORIGIN)
        .normalized()
        .map(Vector3::as_normal)
}

/// Wrong: as long as the transform makes it, a normal dims or brightens.
pub fn unnormalized_normal(i: Mat4x4, n: Normal3) -> Vector3 {
    i.transposed() * Vector3::from(n)
}

/// A factor of 0 is not refused: its inverse is infinite.
pub fn scaled_direction(factors: [f64; 3], d: Vector3) -> Vector3 {
    let [x, y, z] = factors.map(|factor| 1.0 / factor);
    Vector3::new(x * d.x(), y * d.y(), z * d.z())
}

/// Wrong: the program writes the translation into the last row, where the
/// product with a point does not find it.
pub fn translation_in_last_row(by: Point3) -> Mat4x4 {
    Mat4x4::from_rows([
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [by.x(), by.y(), by.z(), 1.0],
    ])
}

/// Wrong: the product of the program takes columns for rows, so that its
/// factors change places.
pub fn product(a: Mat4x4, b: Mat4x4) -> Mat4x4 {
    (a.transposed() * b.transposed()).transposed()
}

/// Wrong: the rule of Sarrus, four diagonals down minus four up, is one for
/// three rows and three columns; of four it leaves out 16 of 24 products.
pub fn determinant_by_sarrus(rows: [[f64; 4]; 4]) -> f64 {
    let product =
        |column: &dyn Fn(usize) -> usize| (0..4).map(|i| rows[i][column(i) % 4]).product();
    let diagonal = |k: usize| -> f64 {
        let [down, up]: [f64; 2] = [product(&|i| k + i), product(&|i| k + 4 - i)];
        down - up
    };
    (0..4).map(diagonal).sum()
}

/// Wrong: without an `else`, the second condition overwrites the nearest hit,
/// so that the last in the list wins.
pub fn last_hit(children: &[Box<dyn Geometry>], ray: &Ray) -> Option<Hit> {
    let mut cached: Option<Hit> = None;
    for child in children {
        let current = child.hit(ray, Interval::AHEAD);
        if let (Some(current), Some(nearest)) = (current, cached)
            && current.t < nearest.t
        {
            cached = Some(current);
            continue;
        }
        cached = current.or(cached);
    }
    cached
}

/// Wrong: the root moves the rim, to which `<` does not belong; no radius is
/// refused; and all `t` above 0 count, those of rays that leave the disc, too.
pub fn disc(a: Point3, n: Normal3, radius: f64, ray: &Ray) -> Option<f64> {
    if ray.direction().dot(n) == 0.0 {
        return None;
    }
    let t = (a - ray.origin()).dot(n) / ray.direction().dot(n);
    let from_centre = (a - ray.at(t)).magnitude();
    let inside = libm::pow(from_centre, 2.0) < libm::pow(radius, 2.0);
    (inside && t > 0.0).then_some(t)
}

/// On whole numbers the formulas give what they say, so that nothing but the
/// extreme cases makes them fail there.
#[cfg(test)]
mod tests {
    use super::*;
    use a04_intersections::Sphere;

    const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

    fn step(to: [f64; 3], by: [f64; 3]) -> Transform {
        let moved = Transform::IDENTITY.translate(Point3::from_glam(to.into()));
        let [x, y, z] = by;
        moved.and_then(|t| t.scale(x, y, z)).unwrap()
    }

    /// The point 1 is doubled and then moved by 4, to 6. The way back halves 6
    /// before it moves, and ends at -1.
    #[test]
    fn the_inverse_of_a_chain_is_in_the_wrong_order() {
        let chained = Chained::IDENTITY
            .then(&step([4.0, 0.0, 0.0], [1.0; 3]))
            .then(&step([0.0; 3], [2.0; 3]));
        let x = Point3::new(1.0, 0.0, 0.0);
        assert_eq!(chained.m * x, Point3::new(6.0, 0.0, 0.0));
        assert_eq!(
            chained.i * Point3::new(6.0, 0.0, 0.0),
            Point3::new(-1.0, 0.0, 0.0)
        );
    }

    /// Stretched three times along x, a surface that faces (4, 3) then faces
    /// (4, 9), which none of them finds.
    #[test]
    fn normals_are_moved_as_the_texts_say() {
        let transform = step([1.0, 2.0, 0.0], [3.0, 1.0, 1.0]);
        let (m, i) = (transform.matrix(), transform.inverse());
        let n = Normal3::new(0.8, 0.6, 0.0);
        let towards = |x, y| Normal3::new(x, y, 0.0).normalized();
        let close = |a: Option<Normal3>, b: Option<Normal3>| {
            approx::assert_abs_diff_eq!(a.unwrap(), b.unwrap(), epsilon = 4.0 * f64::EPSILON);
        };
        close(normal_as_vector(m, n), towards(2.4, 0.6));
        close(transposed_normal(m, n), towards(2.4, 0.6));
        close(normal_as_point(m, n), towards(3.4, 2.6));
        // Twice as large, half as long.
        assert_eq!(
            unnormalized_normal(step([0.0; 3], [2.0; 3]).inverse(), UP),
            Vector3::new(0.0, 0.5, 0.0)
        );
        assert_eq!(i * Vector3::new(3.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
        assert_eq!(
            scaled_direction([2.0, 4.0, 0.5], Vector3::new(3.0, 5.0, 7.0)),
            Vector3::new(1.5, 1.25, 14.0)
        );
    }

    #[test]
    fn a_translation_in_the_last_row_moves_nothing() {
        let matrix = translation_in_last_row(Point3::new(1.0, 2.0, 3.0));
        assert_eq!(matrix.rows()[3], [1.0, 2.0, 3.0, 1.0]);
        assert_eq!(matrix * Point3::ORIGIN, Point3::ORIGIN);
    }

    #[test]
    fn factors_change_places() {
        let (a, b) = (
            step([1.0, 2.0, 3.0], [2.0; 3]),
            step([5.0, 0.0, 0.0], [1.0; 3]),
        );
        assert_eq!(product(a.matrix(), b.matrix()), b.matrix() * a.matrix());
        assert_ne!(product(a.matrix(), b.matrix()), a.matrix() * b.matrix());
    }

    /// Of a diagonal matrix one diagonal is left, of the one with each row moved
    /// one place to the right, too; mirrored, they count as negative. Of all
    /// others, as of the even exchange of two pairs, nothing is found.
    #[test]
    fn sarrus_sees_eight_products_of_four_rows() {
        let places = |columns: [usize; 4]| {
            let mut rows = [[0.0; 4]; 4];
            for (row, column) in columns.into_iter().enumerate() {
                rows[row][column] = [2.0, 3.0, 5.0, 7.0][row];
            }
            determinant_by_sarrus(rows)
        };
        for first in 0..4 {
            let down = [0, 1, 2, 3].map(|i| (first + i) % 4);
            let up = [0, 1, 2, 3].map(|i| (first + 4 - i) % 4);
            assert_eq!((places(down), places(up)), (210.0, -210.0));
        }
        assert_eq!(places([1, 0, 2, 3]), 0.0);
    }

    /// The nearest is found only if it is the last.
    #[test]
    fn of_several_hits_the_last_wins() {
        let sphere = |distance: f64| -> Box<dyn Geometry> {
            Box::new(Sphere::new(Point3::new(0.0, 0.0, -distance - 1.0), 1.0).unwrap())
        };
        let ahead = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, 0.0, -1.0));
        let last = |distances: &[f64]| {
            let children: Vec<_> = distances.iter().map(|d| sphere(*d)).collect();
            last_hit(&children, &ahead).map(|hit| hit.t)
        };
        assert_eq!(last(&[]), None);
        assert_eq!(last(&[3.0, 2.0]), Some(2.0));
        assert_eq!(last(&[2.0, 3.0]), Some(3.0));
        assert_eq!(last(&[3.0, 2.0, 5.0]), Some(5.0));
        assert_eq!(last(&[3.0, -9.0]), Some(3.0));
    }

    /// 3² + 4² = 5², and the rim does not belong to it.
    #[test]
    fn a_disc_ends_before_its_rim() {
        let at = |x: f64, z: f64| {
            let ray = Ray::derived(Point3::new(x, 2.0, z), Vector3::new(0.0, -4.0, 0.0));
            disc(Point3::ORIGIN, UP, 5.0, &ray)
        };
        assert_eq!(
            (at(3.0, 3.9), at(3.0, 4.0), at(3.0, 4.1)),
            (Some(0.5), None, None)
        );
        let aim = |y, d: [f64; 3]| {
            let ray = Ray::derived(Point3::new(0.0, y, 0.0), Vector3::from_glam(d.into()));
            disc(Point3::ORIGIN, UP, 5.0, &ray)
        };
        assert_eq!(aim(2.0, [0.0, 1.0, 0.0]), None, "behind");
        assert_eq!(aim(0.0, [0.0, -1.0, 0.0]), None, "leaving");
        assert_eq!(aim(0.0, [1.0, 0.0, 0.0]), None, "within");
        assert_eq!(aim(-1.0, [1.0, 1.0, 0.0]), Some(1.0), "from below");
    }
}
