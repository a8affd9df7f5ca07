//! A checkerboard in space: cubes that are white and black by turns.

use crate::prelude::*;

/// The colour of a surface at `p`, where its normal is `n`: the colour of the cube
/// just below. Cubes have sides of 1. The one from (0, 0, 0) to (1, 1, 1) is
/// white, and two that share a face have different colours.
///
/// `Vector3::from(n)` is the normal as a vector. A point has `p.x()`, `p.y()` and `p.z()`, and `p.to_glam()`
/// has all three, with functions such as `floor()`.
pub fn checkerboard(p: Point3, n: Normal3) -> Color {
    missing!("white and black", Color::gray(0.5), {
        // On a face between two cubes, rounding would choose one of them.
        let below = (p - Vector3::from(n) * 1e-6).to_glam();
        // Down also below 0, where a cast would round up.
        let number = below.floor().element_sum();
        // Also of a negative number the remainder is 0 or 1.
        if number.rem_euclid(2.0) == 0.0 {
            Color::WHITE
        } else {
            Color::BLACK
        }
    })
}

testing::examples! {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let color = |x, y| checkerboard(Point3::new(x, y, 0.5), up);
    assert_close!(color(0.5, 0.5), Color::WHITE);
    assert_close!(color(-0.5, 0.5), Color::BLACK);
    assert_close!(color(0.5, 0.0), Color::BLACK, "the cube below the floor");
    assert_close!(checkerboard(Point3::new(0.5, 0.0, 0.5), -up), Color::WHITE, "a ceiling");
}
