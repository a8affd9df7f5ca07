//! Lamps between mirrors, compared with the solution.

use crate::prelude::*;

yours! { images }

/// The images in both mirrors: by their distance, the place of the lamp, and the reflections.
type Code = fn(f64, f64, u32) -> [f64; 2];

pub fn exercise() -> Exercise<Code> {
    Exercise::asked(|images: &Code, (width, lamp, n)| images(width, lamp, n))
}
