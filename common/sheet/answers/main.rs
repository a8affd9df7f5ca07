//! Answers to the open sheets, all in one program: `VARIANT=first/glass sheet-answers SCENE --samples N -o FILE`.
//!
//! `first` and `second` are right, and differ in their design. `wrong/glass/0`, `wrong/glass/1`, … are the rows of
//! `wrong/glass.toml`: `first/glass` with one mistake. An optimised build has them all, others only those that are
//! right.

#![allow(clippy::wildcard_imports, reason = "as in a student's program")]

use common::*;

mod ball_scenes;
mod workbench;

/// What a student's file gets by `use crate::functions::*;`.
#[allow(unused_imports, reason = "each answer uses some")]
mod functions {
    pub use a02_math::*;
    pub use a03_rays_cameras::*;
    pub use a04_intersections::*;
    pub use a05_lighting::*;
    pub use a06_shadows_reflection::*;
    pub use a07_transforms::*;
    pub use common::*;
    pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};
}

include!(concat!(env!("OUT_DIR"), "/variants.rs"));

fn main() -> Result<(), Error> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let [scene, "--samples", samples, "-o", file] = words[..] else {
        panic!("SCENE --samples N -o FILE, not {words:?}");
    };
    let variant = std::env::var("VARIANT").unwrap_or_default();
    let samples = samples.parse().expect("a number of samples");
    let image = render(&variant, scene, samples)?;
    let bytes = image.to_rgb8(Transfer::Linear);
    picture_file::save_png(file.as_ref(), image.size(), &bytes)
}

/// Changes all random numbers.
#[allow(dead_code, reason = "some answers use it")]
fn seed() -> u64 {
    let seed = std::env::var("SEED").ok();
    seed.and_then(|seed| seed.parse().ok()).unwrap_or_default()
}
