//! `PointLight`: the lesson's own.

pub use a05_lighting::PointLight;
