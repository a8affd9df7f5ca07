//! Judges students' files of the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod painted;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a01_image_display::*;
    pub use common::*;
    pub use testing::exercises::*;
    pub use testing::yours;

    pub use crate::painted::*;
}

testing::exercises! {
    a01_image_display::stage;
    mod diagonal;
    mod line;
    mod ppm;
    mod set_pixel;
    mod srgb;
    mod thumbnail;
}
