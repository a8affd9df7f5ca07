//! `secondary_ray`: the lesson's own.

pub use a06_shadows_reflection::secondary_ray;
