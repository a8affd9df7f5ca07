//! Fog: distant objects take on its colour.

use common::Color;

/// The rest of a colour behind fog of this thickness, plus the colour of the fog.
///
/// The fog takes the share `density` of the remaining light per length.
/// The distance is at least 0, and infinite where a ray meets nothing.
pub fn fogged(color: Color, fog: Color, density: f64, distance: f64) -> Color {
    // Without fog, infinitely far away is 0 times infinity.
    if density == 0.0 {
        return color;
    }
    let left = libm::exp(-density * distance);
    color * left + fog * (1.0 - left)
}
