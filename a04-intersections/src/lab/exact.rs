//! Where rays meet shapes, to about 30 digits of what the given doubles say:
//! the reference that formulas in doubles are held against.
//!
//! The tests compare it with values of mpmath at 200 digits.

mod double_double;

pub use double_double::{DoubleDouble, product_with_error, sum_with_error};

use DoubleDouble as Number;

/// The exact difference of two triples.
fn difference(a: &[f64; 3], b: &[f64; 3]) -> [Number; 3] {
    std::array::from_fn(|i| Number::from(a[i]) - Number::from(b[i]))
}

fn dot(a: &[Number; 3], b: &[Number; 3]) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[Number; 3], b: &[Number; 3]) -> [Number; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// A ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereMeeting {
    /// How near the ray comes to the centre.
    pub distance: f64,
    /// Both roots, in order, if there are any.
    pub roots: Option<[Number; 2]>,
}

/// Where the ray `o + t d` meets the sphere around `c` of radius `r`.
pub fn sphere(c: &[f64; 3], r: f64, o: &[f64; 3], d: &[f64; 3]) -> SphereMeeting {
    let (f, d) = (difference(o, c), d.map(Number::from));
    let a = dot(&d, &d);
    let middle = -dot(&f, &d) / a;
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

/// Where the ray `o + t d` meets the plane through `a` perpendicular to `n`.
pub fn plane(a: &[f64; 3], n: &[f64; 3], o: &[f64; 3], d: &[f64; 3]) -> Number {
    let n = n.map(Number::from);
    dot(&difference(a, o), &n) / dot(&d.map(Number::from), &n)
}

/// `t`, β and γ of where the ray `o + t d` meets the plane of a triangle.
pub fn triangle([a, b, c]: &[[f64; 3]; 3], o: &[f64; 3], d: &[f64; 3]) -> [Number; 3] {
    let [ab, ac, ao] = [b, c, o].map(|point| difference(point, a));
    let d = d.map(Number::from);
    let (across, moment) = (cross(&d, &ac), cross(&ao, &ab));
    let determinant = dot(&ab, &across);
    [dot(&ac, &moment), dot(&ao, &across), dot(&d, &moment)].map(|x| x / determinant)
}
