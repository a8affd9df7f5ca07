//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[allow(dead_code, reason = "the scenes of another stage")]
mod shape;
mod steps;

testing::exercises! {
    a07_transforms uses
    {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a05_lighting::*, a06_shadows_reflection::*, a07_transforms::*, common::*, crate::shape::*, crate::steps::*}
}
