//! Proves the exercises of this stage, which the book sets, and judges students' files.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod coarse_ball;
mod departure;
mod traced;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use crate::traced::*;
    pub use a05_kinds::prelude::*;
    pub use a06_shadows_reflection::{scenes, *};
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
