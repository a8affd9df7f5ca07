//! A checkerboard in space: cubes that are white and black by turns.

use a02_math::{Normal3, Point3, Vector3};
use common::Color;

/// How far below the surface the cube is looked up.
const BELOW: f64 = 1e-6;

/// The colour of a surface at `p`, where its normal is `n`: the colour of the cube
/// just below. Cubes have sides of 1. The one from (0, 0, 0) to (1, 1, 1) is
/// white, and two that share a face have different colours.
pub fn checkerboard(p: Point3, n: Normal3) -> Color {
    testing::missing("white and black", Color::gray(0.5))
}

testing::examples! {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let color = |x, y| checkerboard(Point3::new(x, y, 0.5), up);
    assert_eq!(color(0.5, 0.5), Color::WHITE);
    assert_eq!(color(1.5, 0.5), Color::BLACK);
    assert_eq!(color(-0.5, 0.5), Color::BLACK);
    assert_eq!(color(0.5, 0.0), Color::BLACK, "the cube below the floor");
    assert_eq!(checkerboard(Point3::new(0.5, 0.0, 0.5), -up), Color::WHITE, "a ceiling");
}
