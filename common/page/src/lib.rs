//! How a page of the book and a WebAssembly module exchange requests and answers.
//!
//! Two kinds of modules speak so: that of the lessons, and those of the students' code. A module
//! exports a function `answer`, which calls `answer_request` with its own answers.

mod exchange;
#[cfg(target_family = "wasm")]
mod memory;
mod reply;

pub use exchange::{pixels, sampling, settings};
#[cfg(target_family = "wasm")]
pub use memory::answer_request;
pub use reply::Reply;
