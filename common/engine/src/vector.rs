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
    scaled(v).map(|(scaled, _)| scaled / scaled.length())
}

/// The vector divided by a power of two, so that its greatest coordinate is at least 1 and
/// below 2, and this power; none where [`normalized`] is none.
pub(crate) fn scaled(v: DVec3) -> Option<(DVec3, f64)> {
    let largest = v.abs().max_element();
    (v.is_finite() && largest > 0.0).then(|| {
        let exponent = libm::ilogb(largest);
        let scaled = v.map(|x| libm::scalbn(x, -exponent));
        (scaled, libm::scalbn(1.0, exponent))
    })
}
