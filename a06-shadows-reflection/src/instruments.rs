//! Instruments: wrappers that count work and record steps, a tracer that leaves out less than
//! the lesson, and the work that no renderer can leave out. No lesson uses them.

mod measured;
pub mod needed;
pub mod recorded;
