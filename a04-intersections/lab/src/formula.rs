//! The formulas of the lesson, and those that it is compared with.
//!
//! Those that the protocol prints stand in [`protocol`](crate::protocol), as printed.

pub mod sphere;
pub mod triangle;
