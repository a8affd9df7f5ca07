//! Arbitrary input: functions that take any bytes, make a picture file, numbers or a
//! scene of them, and panic if the code does not handle it as documented.
//!
//! `tests/` calls them with random inputs that are the same every time, and
//! `libfuzzer/` with inputs that reach new code.

#![expect(clippy::missing_panics_doc, reason = "every check panics")]

pub mod images;
pub mod scene_files;
pub mod scenes;
pub mod values;
