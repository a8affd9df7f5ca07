//! Proves the exercises of this stage, which the book sets, and judges students' files.

#![allow(unexpected_cfgs, reason = "names of exercises")]

/// All names that checks, examples and students' files use.
#[allow(unused_imports, ambiguous_glob_reexports)]
mod prelude {
    pub use a05_kinds::light::*;
    pub use a05_kinds::material::*;
    pub use a05_kinds::prelude::*;
    pub use a05_kinds::seen::*;

    pub use crate::solved::*;
}

include!(concat!(env!("OUT_DIR"), "/exercises.rs"));

exercises!();
