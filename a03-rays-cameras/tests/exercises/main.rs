//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod sky;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, unit, vector};
    pub use a02_math::*;
    pub use a03_questions::camera::*;
    // Its name in starters.
    pub use a03_questions::camera::OwnCamera as Own;
    pub use a03_rays_cameras::*;
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;

    pub use crate::sky::*;
}

testing::exercises! {
    a03_rays_cameras::stage;
    mod fisheye;
    mod mean;
    mod perspective;
    mod picture;
    mod pinhole;
    mod radical_inverse;
    mod ray;
    mod rings;
    mod stripe;
    mod thin_lens;
}
