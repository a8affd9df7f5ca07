//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod pictures;
mod steps;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, vector};
    pub use a02_math::*;
    pub use a03_rays_cameras::*;
    pub use a04_intersections::*;
    pub use a04_questions::shape::*;
    pub use a04_questions::shape_pictures::*;
    pub use a05_lighting::*;
    pub use a06_shadows_reflection::*;
    pub use a07_transforms::*;
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;

    pub use crate::pictures::*;
    pub use crate::steps::*;
}

testing::exercises! {
    a07_transforms::stage;
    mod chain;
    mod disc;
    mod node;
    mod orbits;
    mod ring;
    mod rotation;
    mod sheared;
    mod under_transform;
}
