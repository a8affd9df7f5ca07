//! Pictures of mistakes, for the book, its live pages, and the examples that show them.

pub mod errata;
pub mod go_wrong;
