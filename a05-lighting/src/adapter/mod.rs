//! The code that joins the lesson with its program, the engine and scene files: the scenes by name, a row for each
//! light and material (`registry`), and wrappers that count and record (`instruments`).

pub mod instruments;
pub mod registry;
mod stage;

pub use stage::stage;
