//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a02_math::arrays::{array, point, vector};
    pub use a02_math::*;
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;
}

testing::exercises! {
    a02_math::stage;
    mod angle;
    mod barycentric;
    mod length;
    mod products;
    mod reflected;
    mod rotated;
    mod stretched_normal;
    mod triangle_area;
}
