//! The code that joins the lesson with its program, the engine and scene files: the scenes by name, the choice of
//! the renderer, a row for each camera (`registry`), and wrappers that count and record (`instruments`).

pub mod instruments;
pub mod registry;
mod renderer;
mod stage;
pub mod traced_world;
pub mod views;

pub use stage::stage;
