//! A matt surface between a bright sky and a dark ground.

use crate::prelude::*;

/// The colour of a surface with the normal `n`, of length 1, which scatters `diffuse` of the
/// light of the whole sky and of the whole ground.
///
/// `n.dot(v)` is a dot product.
pub fn hemisphere([diffuse, sky, ground]: [Color; 3], n: Normal3) -> Color {
    let up = Vector3::new(0.0, 1.0, 0.0);
    missing!("the light of sky and ground", diffuse * sky, {
        // Each direction counts by its cosine to the normal, as in Lambert's law: over the
        // part of the sky that is seen, that makes this fraction.
        let fraction = f64::midpoint(1.0, n.dot(up));
        diffuse * (sky * fraction + ground * (1.0 - fraction))
    })
}

testing::examples! {
    let colors = [Color::gray(0.5), Color::BLUE, Color::RED];
    let color = |x, y| hemisphere(colors, Normal3::new(x, y, 0.0));
    assert_close!(color(0.0, 1.0), Color::BLUE * 0.5, "a floor sees the sky");
    assert_close!(color(0.0, -1.0), Color::RED * 0.5, "a ceiling sees the ground");
    assert_close!(color(1.0, 0.0), (Color::BLUE + Color::RED) * 0.25, "a wall sees half of each");
}
