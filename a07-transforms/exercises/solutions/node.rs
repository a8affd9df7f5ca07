//! `Node`: the lesson's own.

pub use a07_transforms::Node;
