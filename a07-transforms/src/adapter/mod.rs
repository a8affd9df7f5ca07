//! The code that joins the lesson with its program, the engine and scene files: the scenes by name, and a row for
//! each shape (`registry`).

pub mod registry;
mod stage;

pub use stage::{stage, traced};
