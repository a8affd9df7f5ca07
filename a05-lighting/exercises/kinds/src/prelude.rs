//! All names that the exercises of this stage and of the next one use in common.

#![allow(ambiguous_glob_reexports, reason = "the names that are used are not")]

pub use a02_math::arrays::{array, point, vector};
pub use a02_math::*;
pub use a03_rays_cameras::*;
pub use a04_intersections::*;
pub use a05_lighting::{scenes, *};
pub use common::*;
pub use testing::exercises::*;
// Not the picture of a scene.
pub use testing::exercises::Picture;
pub use testing::yours;

pub use crate::numbers::*;
pub use crate::shown::*;
