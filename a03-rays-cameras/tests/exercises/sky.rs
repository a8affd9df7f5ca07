//! The names that the examples of the camera exercises use.

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
