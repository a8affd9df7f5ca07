//! Instruments: wrappers that count work and record steps, and a tracer that does all work. No
//! lesson uses them.

mod all_work;
pub mod recorded;
