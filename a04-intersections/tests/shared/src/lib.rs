//! What the tests of this stage and of the stages above share. A check fails by a panic.

#![allow(clippy::missing_panics_doc, reason = "every check of a test panics")]

pub mod compare;
pub mod support;
