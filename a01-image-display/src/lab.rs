//! The laboratory: measures the lesson of this stage, and is no part of it.

pub mod experiments;
