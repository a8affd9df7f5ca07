//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod camera;
mod sky;

testing::exercises! {
    a03_rays_cameras uses
    {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, common::*, crate::camera::*, crate::sky::*}
}
