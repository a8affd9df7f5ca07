//! Shadows and mirrors.
