//! What examples and pictures of cameras use.

#[allow(
    unused_imports,
    reason = "solutions use all, and a handout may leave them out"
)]
pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI};

use crate::prelude::*;

/// The direction of a camera's ray through the position (`x`, `y`), for examples.
pub fn direction(camera: &impl Camera, size: Size, x: f64, y: f64) -> [f64; 3] {
    let ray = camera.ray_for(size, x, y);
    array(ray.direction())
}

/// Marks positions by black crosses. They are counted in pixels from the middle, to the right and
/// upwards.
pub fn mark(image: &mut Image, positions: &[[f64; 2]]) {
    let [width, height] = [image.size().width(), image.size().height()].map(f64::from);
    for [right, up] in positions {
        let column = (width / 2.0 + right).floor();
        let row = (height / 2.0 - up).floor();
        for step in -4..=4 {
            let step = f64::from(step);
            for [x, y] in [[column + step, row], [column, row + step]] {
                if x >= 0.0 && y >= 0.0 {
                    image.set(x as u32, y as u32, Color::BLACK);
                }
            }
        }
    }
}
