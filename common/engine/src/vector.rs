//! Vectors that are normalised, whatever their length.

use glam::DVec3;

/// Squared lengths for which the root is the length; outside, the square has lost
/// digits or is infinite.
pub(crate) const SQUARES: std::ops::RangeInclusive<f64> = 1e-280..=1e280;

/// The vector of length 1 in the same direction; none for the zero vector and for
/// coordinates that are not finite. Very long and very short vectors are first
/// scaled by a power of two, which rounds nothing.
#[inline]
pub(crate) fn normalized(v: DVec3) -> Option<DVec3> {
    let squared = v.length_squared();
    if SQUARES.contains(&squared) {
        return Some(v / squared.sqrt());
    }
    let largest = v.abs().max_element();
    (v.is_finite() && largest > 0.0).then(|| {
        let exponent = libm::ilogb(largest);
        let scaled = v.map(|x| libm::scalbn(x, -exponent));
        scaled / scaled.length()
    })
}
