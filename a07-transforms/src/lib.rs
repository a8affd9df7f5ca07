//! Transformed geometry, the scene graph and the disc.
