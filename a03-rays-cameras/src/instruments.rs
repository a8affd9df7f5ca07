//! Instruments: wrappers that count work and record steps, drawings of rays, orbiting cameras, and
//! what a pixel owes to each number of a scene file, for the program and the window. No lesson uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

mod drawing;
pub mod orbit_camera;
pub mod pixel_trace;
pub mod recorded;
mod seen_rays;
pub mod sensitivity;
