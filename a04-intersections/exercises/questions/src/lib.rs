//! What exercises of this stage and of those above ask in the same way.

pub mod boxes;
pub mod shape;
pub mod shape_pictures;
