//! Instruments: wrappers that count work and record steps, and the positions of lights. No lesson
//! uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

mod light_positions;
pub mod recorded;

pub use light_positions::light_positions;
