//! Instruments: wrappers that count work and record steps, and the numbers of shapes for the
//! laboratory. No lesson uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

mod numbers;
pub mod objects;
pub mod recorded;
