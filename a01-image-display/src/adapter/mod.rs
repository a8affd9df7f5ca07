//! The code that joins the lesson with its program.

mod stage;

pub use stage::stage;
