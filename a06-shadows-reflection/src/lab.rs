//! The laboratory: what measures the lesson of this stage, and is no part of it.

#[doc(hidden)]
pub mod all_work;
#[doc(hidden)]
pub mod counted;
pub mod experiments;
#[doc(hidden)]
pub mod explain;
pub mod extremes;
#[doc(hidden)]
pub mod protocol;
mod shiny;
