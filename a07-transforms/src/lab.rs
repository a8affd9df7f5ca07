//! The laboratory: what measures the lesson of this stage, and is no part of it.

pub mod counted;
pub mod experiments;
pub mod explain;
pub mod extremes;
#[doc(hidden)]
pub mod protocol;
