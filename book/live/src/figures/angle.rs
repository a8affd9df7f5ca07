//! A small angle, by the arc tangent of the lesson and by an arc cosine.

use a02_lab::protocol;
use a02_math::Vector3;

use crate::Reply;

/// Powers of ten of the curves: four each decade.
const POWERS: i32 = 48;

/// Both angles between (1, 0, 0) and (1, t, 0), and their relative errors: the exact
/// angle is the arc tangent of t.
fn angles(tangent: f64) -> [f64; 4] {
    let (a, b) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(1.0, tangent, 0.0));
    let (ours, by_cosine) = (a.angle(b), protocol::angle_by_arc_cosine(a, b));
    let exact = libm::atan(tangent);
    let error = |found: f64| ((found - exact) / exact).abs();
    [ours, by_cosine, error(ours), error(by_cosine)]
}

/// Number: the power of ten of the tangent t. The curves are the errors of the arc cosine
/// for tangents from 10^-12 to 1.
pub fn answer([power]: [f64; 1]) -> Reply {
    let tangent = libm::pow(10.0, power);
    let [ours, by_cosine, our_error, cosine_error] = angles(tangent);
    let powers = (-POWERS..=0).map(|n| f64::from(n) / 4.0);
    let errors = powers
        .clone()
        .map(|power| angles(libm::pow(10.0, power))[3]);
    Reply::default()
        .with("tangent", [tangent])
        .with("ours", [ours])
        .with("by_cosine", [by_cosine])
        .with("our_error", [our_error])
        .with("cosine_error", [cosine_error])
        .with("powers", powers)
        .with("errors", errors)
}
