//! Instruments: wrappers that count work and record steps, and a tracer that leaves out less than
//! the lesson. No lesson uses them.

pub mod instrumented;
mod omitting_tracer;
