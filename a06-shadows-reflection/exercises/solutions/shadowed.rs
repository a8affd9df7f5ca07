//! `is_shadowed`: the lesson's own.

pub use a06_shadows_reflection::is_shadowed;
