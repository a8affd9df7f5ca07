//! `PerspectiveCamera`: the lesson's own.

pub use a03_rays_cameras::PerspectiveCamera;
