//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod light;
mod material;
mod seen;
mod shaded_pictures;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, unit, vector};
    pub use a02_math::*;
    pub use a03_rays_cameras::*;
    pub use a04_intersections::*;
    pub use a05_lighting::{scenes, *};
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;

    pub use crate::light::*;
    pub use crate::material::*;
    pub use crate::seen::*;
    pub use crate::shaded_pictures::*;
}

testing::exercises! {
    a05_lighting::stage;
    mod blinn_phong;
    mod directional_light;
    mod fading_light;
    mod hemisphere;
    mod lambert;
    mod phong;
    mod point_light;
    mod soft_spot;
    mod spot_light;
}
