//! Proves the exercises of this stage, which the book sets, and judges students' files.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod coarse_ball;
mod departure;
mod traced;

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a05_kinds::prelude::*;
    pub use a06_shadows_reflection::{scenes, *};

    pub use crate::solved::*;
    pub use crate::traced::*;
}

include!(concat!(env!("OUT_DIR"), "/exercises.rs"));

exercises!();
