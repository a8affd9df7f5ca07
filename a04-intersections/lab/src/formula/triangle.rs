//! The intersection of a line and a triangle.

use crate::line::Line;
use crate::number::{Number, Triple, cross, difference, dot};

/// Where a line meets the plane of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct PlaneHit<N> {
    /// The parameter of the line.
    pub t: N,
    /// The weight of the second corner, b.
    pub beta: N,
    /// The weight of the third corner, c.
    pub gamma: N,
}

/// The formula of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997.
pub fn moeller_trumbore<N: Number>([a, b, c]: &[Triple<N>; 3], line: &Line<N>) -> PlaneHit<N> {
    let (ab, ac) = (difference(b, a), difference(c, a));
    let from_a = difference(&line.origin, a);
    let across = cross(&line.direction, &ac);
    let moment = cross(&from_a, &ab);
    let determinant = dot(&ab, &across);
    PlaneHit {
        t: dot(&ac, &moment) / determinant,
        beta: dot(&from_a, &across) / determinant,
        gamma: dot(&line.direction, &moment) / determinant,
    }
}

impl PlaneHit<f64> {
    /// The `t` of a hit ahead, for weights that are not negative. It compares the rounded weights,
    /// as the exercise does, so that two triangles at an edge may both lose a ray. Those of a line
    /// along the plane are infinite or no numbers, and no hit.
    pub fn hit(&self) -> Option<f64> {
        let is_inside = self.beta >= 0.0 && self.gamma >= 0.0 && self.beta + self.gamma <= 1.0;
        (is_inside && self.t > 0.0).then_some(self.t)
    }
}

/// The lesson's formula, the test of Woop, Benthin and Wald, "Watertight Ray/Triangle
/// Intersection", JCGT 2(1), 2013, section 3: the `t` of a hit ahead. Space is sheared until the line
/// is the z axis; the three areas decide, and are the weights of the corners' depths. An area is a
/// `difference_of_products` of a, b, c and d, `a b - c d`.
pub fn watertight(
    corners: &[Triple; 3],
    line: &Line,
    difference_of_products: impl Fn(f64, f64, f64, f64) -> f64,
) -> Option<f64> {
    let (o, d) = (&line.origin, &line.direction);
    let [x, y, z] = axes_along(d);
    let (shear_x, shear_y, scale_z) = (d[x] / d[z], d[y] / d[z], 1.0 / d[z]);
    let [a, b, c] = corners.map(|corner| {
        let depth = corner[z] - o[z];
        [
            (corner[x] - o[x]) - shear_x * depth,
            (corner[y] - o[y]) - shear_y * depth,
            scale_z * depth,
        ]
    });
    let u = difference_of_products(c[0], b[1], c[1], b[0]);
    let v = difference_of_products(a[0], c[1], a[1], c[0]);
    let w = difference_of_products(b[0], a[1], b[1], a[0]);
    let is_any_negative = u < 0.0 || v < 0.0 || w < 0.0;
    let is_any_positive = u > 0.0 || v > 0.0 || w > 0.0;
    let area = u + v + w;
    if (is_any_negative && is_any_positive) || area == 0.0 || is_beside(&[a, b, c]) {
        return None;
    }
    let t = (u * a[2] + v * b[2] + w * c[2]) / area;
    (t > 0.0).then_some(t)
}

/// The axes in cyclic order; the last one is that of the direction's largest coordinate.
fn axes_along(direction: &Triple) -> [usize; 3] {
    let magnitudes = direction.map(f64::abs);
    let mut largest = 0;
    for axis in 1..3 {
        if magnitudes[axis] > magnitudes[largest] {
            largest = axis;
        }
    }
    [(largest + 1) % 3, (largest + 2) % 3, largest]
}

/// Whether all sheared corners lie on one side of the line, in x or in y.
fn is_beside(corners: &[Triple; 3]) -> bool {
    let mut is_beside = false;
    for axis in 0..2 {
        is_beside |= corners.iter().all(|corner| corner[axis] > 0.0);
        is_beside |= corners.iter().all(|corner| corner[axis] < 0.0);
    }
    is_beside
}

/// `a b - c d` as it stands: two roundings of products, which a difference near 0 uncovers.
pub fn rounded(a: f64, b: f64, c: f64, d: f64) -> f64 {
    a * b - c * d
}

/// With the rounding error of `c d` added again, by fused operations, which round once. The result
/// is at most 1.5 units in the last place off (Jeannerod, Louvet and Muller, "Further Analysis of
/// Kahan's Algorithm for the Accurate Computation of 2 × 2 Determinants", Mathematics of
/// Computation 82, 2013).
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two is what the method lives on"
)]
pub fn fused(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    let difference = a.mul_add(b, -product);
    let error = (-c).mul_add(d, product);
    difference + error
}
