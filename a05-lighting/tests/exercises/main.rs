//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod light;
mod material;
mod scene;

testing::exercises! {
    a05_lighting uses
    {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a05_lighting::*, common::*, a05_lighting::{scenes, stage}, crate::light::*, crate::material::*, crate::scene::*}
}
