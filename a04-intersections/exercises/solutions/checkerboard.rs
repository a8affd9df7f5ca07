//! A checkerboard in space: cubes that are white and black by turns.

use a02_math::{Normal3, Point3, Vector3};
use common::Color;

/// How far below the surface the cube is looked up.
const BELOW: f64 = 1e-6;

/// The colour of a surface at `p`, where its normal is `n`: the colour of the cube
/// just below. Cubes have sides of 1. The one from (0, 0, 0) to (1, 1, 1) is
/// white, and two that share a face have different colours.
pub fn checkerboard(p: Point3, n: Normal3) -> Color {
    // On a face between two cubes, rounding would choose one of them.
    let below = (p - Vector3::from(n) * BELOW).to_glam();
    // Down also below 0, where a cast would round up.
    let number = below.floor().element_sum();
    // Also of a negative number the remainder is 0 or 1.
    if number.rem_euclid(2.0) == 0.0 {
        Color::WHITE
    } else {
        Color::BLACK
    }
}
