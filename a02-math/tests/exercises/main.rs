//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod drawn;
#[path = "../../src/scenes.rs"]
mod scenes;

// The types that `scenes` takes from its crate.
use a02_math::Normal3;
use drawn::Vector3;

testing::exercises! {
    a02_math uses
    {a02_math::*, a02_math::arrays::{point, vector}, common::*, crate::drawn::scene}
}
