//! Fog: what is far away takes on its colour.

use common::Color;

/// What is left of a colour behind fog of this thickness, and what the fog adds.
///
/// The fog takes the share `density` of the light per length, of what is left.
/// The distance is at least 0, and infinite where a ray meets nothing.
pub fn fogged(color: Color, fog: Color, density: f64, distance: f64) -> Color {
    testing::missing("the colour behind the fog", color)
}
