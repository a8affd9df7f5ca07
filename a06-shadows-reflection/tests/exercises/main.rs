//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod traced;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, unit, vector};
    pub use a02_math::*;
    pub use a03_rays_cameras::*;
    pub use a04_intersections::*;
    pub use a05_lighting::*;
    pub use a06_shadows_reflection::{scenes, *};
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;

    pub use crate::traced::*;
}

testing::exercises! {
    a06_shadows_reflection::stage;
    mod fogged;
    mod images;
    mod leaving;
    mod mirror;
    mod reflectance;
    mod refracted;
    mod shadow_start;
    mod shadowed;
}
