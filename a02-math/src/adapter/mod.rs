//! The code that joins the lesson with its program, and with tables of inputs.

pub mod arrays;
mod stage;

pub use stage::stage;
