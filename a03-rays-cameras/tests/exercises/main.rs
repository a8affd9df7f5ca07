//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod camera;
mod sky;

testing::exercises! {
    use {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, common::*, crate::camera::*, crate::sky::*};
    starters {
        ray => |check| ray::check(check, at, t_of);
        perspective => |check| perspective::check(check, PerspectiveCamera::new);
        pinhole => |check| pinhole::check(check, PinholeCamera::new);
        stripe => |check| stripe::check(check, Sky::new, Sky::stripe);
        picture => |check| picture::check(check, &picture);
    }
    solutions {
        rings => |check| rings::check(check, ring);
        mean => |check| mean::check(check, mean);
        radical_inverse => |check| radical_inverse::check(check, radical_inverse);
        fisheye => |check| fisheye::check(check, |basis, angle| Ok(Fisheye::new(basis, angle)));
        thin_lens => |check| thin_lens::check(check, through_lens);
    }
}
