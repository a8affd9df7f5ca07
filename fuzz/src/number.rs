//! Numbers from bytes: every bit pattern is possible, and those are frequent that make
//! a scene or break a formula.

use a02_math::{Normal3, Point3, Vector3};
use arbitrary::{Result, Unstructured};
use common::Color;

/// Ends of the ranges that constructors and number formats have, and numbers
/// beyond.
#[rustfmt::skip]
const ENDS: [f64; 24] = [
    0.0, -0.0, 1.0, -1.0, 1.0 - f64::EPSILON / 2.0, 1.0 + f64::EPSILON,
    1e-100, 1e100, -1e100, 1e-7, 1e-12, 1e50, 1e-50, 1e150, 1e-150, 1e160, 1e-160,
    std::f64::consts::PI, std::f64::consts::FRAC_PI_2,
    f64::MIN_POSITIVE, f64::MAX, 5e-324, f64::INFINITY, f64::NAN,
];

/// Any number.
pub fn number(u: &mut Unstructured) -> Result<f64> {
    Ok(match u.int_in_range(0..=7)? {
        0 => f64::from_bits(u.arbitrary()?),
        1 => *u.choose(&ENDS)?,
        // A power of two from 2^-384 to 2^381, whose sum with anything rounds.
        2 => {
            let exponent = 3 * i64::from(u.arbitrary::<i8>()?);
            f64::from_bits(((1023 + exponent) as u64) << 52)
        }
        3 => f64::from(u.arbitrary::<i16>()?) / 4096.0,
        // So few that they repeat: edges that touch, shapes within each other.
        _ => f64::from(u.arbitrary::<i8>()?) / 8.0,
    })
}

/// Three of them.
fn three(u: &mut Unstructured) -> Result<[f64; 3]> {
    Ok([number(u)?, number(u)?, number(u)?])
}

/// A point of three of these numbers.
pub fn point(u: &mut Unstructured) -> Result<Point3> {
    Ok(Point3::from_glam(three(u)?.into()))
}

/// A vector of three of these numbers.
pub fn vector(u: &mut Unstructured) -> Result<Vector3> {
    Ok(Vector3::from_glam(three(u)?.into()))
}

/// A normal of three of these numbers.
pub fn normal(u: &mut Unstructured) -> Result<Normal3> {
    vector(u).map(Vector3::as_normal)
}

/// A colour, most of them from 0 to 1.
pub fn color(u: &mut Unstructured) -> Result<Color> {
    let any = u.ratio(1, 4)?.then(|| three(u)).transpose()?;
    Ok(match any {
        Some([r, g, b]) => Color::new(r, g, b),
        None => Color::from_packed(u.arbitrary()?),
    })
}
