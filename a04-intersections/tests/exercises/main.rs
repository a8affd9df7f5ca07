//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[path = "../../../a03-rays-cameras/tests/exercises/camera.rs"]
mod camera;
mod shape;

testing::exercises! {
    a04_intersections uses
    {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a04_intersections::scenes::*, common::*, crate::shape::*}
}
