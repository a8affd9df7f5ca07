//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod painted;

testing::exercises! {
    a01_image_display uses
    {a01_image_display::*, common::*, crate::painted::*}
}
