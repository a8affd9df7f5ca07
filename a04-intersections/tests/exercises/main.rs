//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, vector};
    pub use a02_math::*;
    pub use a03_questions::camera::*;
    pub use a03_rays_cameras::*;
    pub use a04_intersections::scenes::*;
    pub use a04_intersections::*;
    pub use a04_questions::boxes::*;
    pub use a04_questions::shape::*;
    pub use a04_questions::shape_pictures::*;
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;
}

testing::exercises! {
    a04_intersections::stage;
    mod axis_aligned_box;
    mod checkerboard;
    mod cylinder;
    mod may_meet;
    mod nearest;
    mod orthographic;
    mod plane;
    mod read_obj;
    mod signed_distance;
    mod six_planes;
    mod sphere;
    mod torus;
    mod triangle;
}
