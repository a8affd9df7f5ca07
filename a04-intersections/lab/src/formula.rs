//! The formulas of the lesson, and those that it is compared with, over all types of numbers.
//!
//! Those that the protocol prints stand in [`protocol`](crate::protocol), as printed.

pub mod aligned_box;
pub mod plane;
pub mod sphere;
pub mod triangle;
