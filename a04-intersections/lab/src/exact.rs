//! Intersections of rays and shapes with about 30 digits, for the given doubles:
//! the reference for formulas in double precision.
//!
//! The tests compare it with values of mpmath at 200 digits.

pub use a02_lab::exact::DoubleDouble;

use DoubleDouble as Number;

use super::support::dot;

/// The exact difference of two triples.
pub fn difference(a: &[f64; 3], b: &[f64; 3]) -> [Number; 3] {
    std::array::from_fn(|i| Number::from(a[i]) - Number::from(b[i]))
}

fn cross(a: &[Number; 3], b: &[Number; 3]) -> [Number; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The intersection of a ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereMeeting {
    /// Distance of the ray from the centre.
    pub distance: f64,
    /// Both roots, in order, if the ray hits the sphere.
    pub roots: Option<[Number; 2]>,
}

/// Intersection of the ray `o + t d` with the sphere around `c` of radius `r`.
pub fn sphere(c: &[f64; 3], r: f64, o: &[f64; 3], d: &[f64; 3]) -> SphereMeeting {
    let (f, d) = (difference(o, c), d.map(Number::from));
    let a = dot(&d, &d);
    let middle = dot(&difference(c, o), &d) / a;
    let l = std::array::from_fn(|i| f[i] + d[i] * middle);
    let beside = dot(&l, &l);
    let discriminant = Number::from(r) * Number::from(r) - beside;
    let roots = (discriminant.value() >= 0.0).then(|| {
        let half = (discriminant / a).sqrt();
        [middle - half, middle + half]
    });
    SphereMeeting {
        distance: beside.sqrt().value(),
        roots,
    }
}

/// The `t` of the ray `o + t d` at the plane through `a` perpendicular to `n`.
pub fn plane(a: &[f64; 3], n: &[f64; 3], o: &[f64; 3], d: &[f64; 3]) -> Number {
    let n = n.map(Number::from);
    dot(&difference(a, o), &n) / dot(&d.map(Number::from), &n)
}

/// `t`, β and γ of the ray `o + t d` at the plane of a triangle.
pub fn triangle([a, b, c]: &[[f64; 3]; 3], o: &[f64; 3], d: &[f64; 3]) -> [Number; 3] {
    let [ab, ac, ao] = [b, c, o].map(|point| difference(point, a));
    let d = d.map(Number::from);
    let (across, moment) = (cross(&d, &ac), cross(&ao, &ab));
    let determinant = dot(&ab, &across);
    [dot(&ac, &moment), dot(&ao, &across), dot(&d, &moment)].map(|x| x / determinant)
}
