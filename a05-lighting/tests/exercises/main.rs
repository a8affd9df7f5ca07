//! Proves the exercises of this stage, which the book sets, and judges students' files.

#![allow(unexpected_cfgs, reason = "names of exercises")]

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a05_kinds::light::*;
    pub use a05_kinds::material::*;
    pub use a05_kinds::prelude::*;
    pub use a05_kinds::seen::*;
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
