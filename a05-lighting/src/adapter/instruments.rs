//! Instruments: wrappers that count work and record steps. No lesson uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

pub mod instrumented;
