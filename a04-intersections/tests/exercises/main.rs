//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[path = "../../../a03-rays-cameras/tests/exercises/camera.rs"]
mod camera;
mod shape;

testing::exercises! {
    use {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a04_intersections::scenes::*, common::*, crate::shape::*};
    starters {
        orthographic => |check| orthographic::check(check, OrthographicCamera::new);
        plane => |check| plane::check(check, &|a, n| shape::boxed(Plane::new(a, n)));
        axis_aligned_box => |check| axis_aligned_box::check(check, &|lbf, run| shape::boxed(AxisAlignedBox::new(lbf, run)));
        triangle => |check| triangle::check(check, &|a, b, c| shape::boxed(Triangle::new(a, b, c)));
        nearest => |check| nearest::check(check, nearest);
        sphere => |check| sphere::check(check, &|c, r| shape::boxed(Sphere::new(c, r)));
        six_planes => |check| six_planes::check(check, &|lbf, run| shape::boxed(SixPlanes::new(lbf, run)));
    }
    solutions {
        signed_distance => |check| signed_distance::check(check, signed_distance);
        may_meet => |check| may_meet::check(check, may_meet);
        checkerboard => |check| checkerboard::check(check, checkerboard);
        cylinder => |check| cylinder::check(check, &|r, height| shape::boxed(Cylinder::new(r, height)));
        read_obj => |check| read_obj::check(check, read_obj);
        torus => |check| torus::check(check, &|ring, r| shape::boxed(Torus::new(ring, r)));
    }
}
