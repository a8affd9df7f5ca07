//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[path = "../../../a05-lighting/tests/exercises/scene.rs"]
mod scene;
mod traced;

testing::exercises! {
    a06_shadows_reflection uses
    {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a05_lighting::*, a06_shadows_reflection::*, common::*, a06_shadows_reflection::{scenes, stage}, crate::scene::*, crate::traced::*}
}
