//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[allow(dead_code, reason = "the scenes of another stage")]
#[path = "../../../a04-intersections/tests/exercises/shape.rs"]
mod shape;
mod steps;

testing::exercises! {
    use {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a05_lighting::*, a06_shadows_reflection::*, a07_transforms::*, common::*, crate::shape::*, crate::steps::*};
    starters {
        chain => |check| chain::check(check, chain);
        under_transform => |check| under_transform::check(check, ray_to_object, normal_from_object);
        node => |check| node::check(check, |t, children| children.into_iter().fold(Node::new(t), Node::with));
        disc => |check| disc::check(check, &|c, n, r| shape::boxed(Disc::new(c, n, r)));
    }
    solutions {
        ring => |check| ring::check(check, &|c, n, hole, r| shape::boxed(Ring::new(c, n, hole, r)));
        orbits => |check| orbits::check(check, orbits);
        sheared => |check| sheared::check(check, Sheared::new);
        rotation => |check| rotation::check(check, rotation);
    }
}
