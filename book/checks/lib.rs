//! Checks that the book and the crates say the same.
//!
//! mdBook renders a listing that is empty, a link that leads nowhere, and a
//! picture that is missing without a word. Here each of them is a complaint
//! that names file and line, and the tests fail while there is one.

pub mod caption;
pub mod changes;
pub mod chapter;
mod files;
mod heading;
pub mod include;
pub mod link;
mod page;
pub mod picture;
pub mod section;

pub use files::Files;
