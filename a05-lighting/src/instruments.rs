//! Instruments: wrappers that count work and record steps, and the places of lights. No lesson
//! uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

mod light_places;
pub mod watched;

pub use light_places::light_places;
