//! What exercises of this stage and of those above ask in the same way.

pub mod camera;
