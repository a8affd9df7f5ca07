//! The formulas of the protocol as it prints them, mistakes included. They
//! are only for comparison, and to render pictures of the mistakes.

use a02_math::{Direction, Normal3, Point3, Vector3};

/// Wrong: if rounding makes the cosine greater than 1 or less than -1, the angle is
/// NaN. Comparisons with NaN are false, so the point counts as lit.
pub fn spot_light_illuminates(
    position: Point3,
    direction: Vector3,
    half_angle: f64,
    point: Point3,
) -> bool {
    let to_point = point - position;
    let cosine = to_point.dot(direction) / (to_point.magnitude() * direction.magnitude());
    let is_outside = libm::acos(cosine) > half_angle;
    !is_outside
}

/// Wrong: the text prints the cosine, the program computes the arc cosine.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    libm::cos(a.dot(b) / (a.magnitude() * b.magnitude()))
}

/// Wrong: uses a position, which a directional light does not have.
pub fn directional_light_illuminates(position: Point3, point: Point3) -> bool {
    (position - point).magnitude() > 0.00001
}

/// Wrong: by the text the light always comes from above.
pub const DIRECTIONAL_LIGHT_FROM: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The cosine for a light at a position. It is 0 if the squared distance overflows.
///
/// Wrong for a light at the point itself: 0 / 0 is NaN, and `max` in Java returns
/// NaN, unlike `max` in Rust.
pub fn lambert(n: Normal3, position: Point3, point: Point3) -> f64 {
    let way = position - point;
    let cosine = n.dot(way * (1.0 / way.magnitude()));
    if cosine < 0.0 { 0.0 } else { cosine }
}

/// Wrong: 0 and NaN to the power of 0 are 1, and the power of a cosine just above
/// 1 is unbounded. Surfaces that face away from the light have highlights, too.
pub fn highlight(cosine: f64, exponent: f64) -> f64 {
    libm::pow(cosine.max(0.0), exponent)
}

/// Wrong: the surface colour `cr` is a factor of the highlight, too, so that there
/// is no highlight in channels in which the surface is black; and there is one
/// light instead of the sum over all lights.
pub fn phong(cr: f64, ca: f64, cl: f64, n_l: f64, highlight: f64) -> f64 {
    cr * (ca + cl * n_l.max(0.0) + cl * highlight)
}

/// Wrong: clamped after every operation, not once at the end.
pub fn clamped_product(a: f64, b: f64) -> f64 {
    (a.clamp(0.0, 1.0) * b.clamp(0.0, 1.0)).clamp(0.0, 1.0)
}

/// Wrong: with whole numbers from 0 to 255 every product loses its fraction.
pub fn integer_product(a: f64, b: f64) -> f64 {
    let [a, b] = [a, b].map(|channel| (channel * 255.0) as u32);
    f64::from(a * b / 255) / 255.0
}
