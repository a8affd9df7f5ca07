//! The formulas of the protocol as it prints them, mistakes included. The
//! tables hold them against what is right, and only pictures of the mistakes
//! are rendered with them.

#![expect(
    clippy::must_use_candidate,
    reason = "for tables and pictures of mistakes"
)]

use a02_math::{Direction, Normal3, Point3, Vector3};

/// Wrong: a cosine above 1 or below -1, by rounding, has no arc. For then the
/// angle is NaN, which is not greater than anything: lit.
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

/// Wrong: the text takes the cosine where the program takes the arc cosine.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    libm::cos(a.dot(b) / (a.magnitude() * b.magnitude()))
}

/// Wrong: asks for a position, which a light from far away has not.
pub fn directional_light_illuminates(position: Point3, point: Point3) -> bool {
    (position - point).magnitude() > 0.00001
}

/// Wrong: by the text the light always comes from above.
pub const DIRECTIONAL_LIGHT_FROM: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The cosine for a light at a position. Where the way is longer than numbers
/// can be squared it is dark.
pub fn lambert(n: Normal3, position: Point3, point: Point3) -> f64 {
    let way = position - point;
    n.dot(way * (1.0 / way.magnitude())).max(0.0)
}

/// Wrong: 0 to the power of 0 is 1, so does NaN to the power of 0, and a cosine
/// just above 1 has no bound. Surfaces turned away from the light shine, too.
pub fn highlight(cosine: f64, exponent: f64) -> f64 {
    libm::pow(cosine.max(0.0), exponent)
}

/// Wrong: the surface colour `cr` stands before the highlight, too, so that
/// there is none in channels that the surface does not have; and there is one
/// light, where the sum over all should stand.
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
