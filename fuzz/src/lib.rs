//! Input that nobody meant: for each door through which bytes of others come
//! in, a function that takes any bytes and panics if they do harm.
//!
//! `tests/` calls them with the files in `seeds/` and with changes of them, and
//! `libfuzzer/` with inputs that reach new code.

pub mod command_line;
pub mod images;
pub mod inputs;
mod number;
pub mod numbers;
pub mod scenes;
mod shapes;
