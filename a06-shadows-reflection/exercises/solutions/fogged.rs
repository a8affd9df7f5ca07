//! Fog: distant objects take on its colour.

use crate::prelude::*;

/// The rest of a colour behind fog of this thickness, plus the colour of the fog.
///
/// The fog takes the fraction `density` of the remaining light per length.
/// The distance is at least 0, and infinite where a ray meets nothing.
pub fn fogged(color: Color, fog: Color, density: f64, distance: f64) -> Color {
    missing!("the colour behind the fog", color, {
        // Without fog, infinitely far away is 0 times infinity.
        if density == 0.0 {
            return color;
        }
        let left = libm::exp(-density * distance);
        color * left + fog * (1.0 - left)
    })
}

testing::examples! {
    let foggy = |density, t| fogged(Color::RED, Color::BLUE, density, t).channels();
    assert_close!(foggy(1.0, 0.0), [1.0, 0.0, 0.0], "near by");
    assert_close!(foggy(std::f64::consts::LN_2, 1.0), [0.5, 0.0, 0.5]);
    assert_close!(foggy(1.0, f64::INFINITY), [0.0, 0.0, 1.0], "nothing but fog");
}
