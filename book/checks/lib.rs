//! Checks that the book and the crates say the same, as far as neither mdBook nor
//! the link checker of `book/build` does.
//!
//! A check returns a complaint with file and line for each mistake.

pub mod caption;
pub mod changes;
mod files;
pub mod include;
pub mod left_over;

pub use files::{Files, ending};
