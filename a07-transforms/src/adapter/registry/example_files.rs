//! Files of the folder `scenes/`, for programs that read no folder: a page in a browser, and the
//! tests that make hostile files of good ones.

/// Names every shape, light and camera.
pub const SHAPES: &str = include_str!("../../../scenes/shapes.toml");

/// The mesh that it names, as `pyramid.obj`.
pub const PYRAMID: &[u8] = include_bytes!("../../../scenes/pyramid.obj");

/// A mesh in another format.
pub const STAR: &[u8] = include_bytes!("../../../scenes/star.ply");
