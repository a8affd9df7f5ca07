//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[path = "../../../a03-rays-cameras/tests/exercises/camera.rs"]
mod camera;
mod shape;

testing::exercises! {
    use {a02_math::*, a03_rays_cameras::*, a04_intersections::*, a04_intersections::scenes::*, common::*, crate::shape::*};
    starters {
        orthographic => |check| orthographic::check(check, OrthographicCamera::new);
        plane => |check| plane::check(check, Plane::new);
        axis_aligned_box => |check| axis_aligned_box::check(check, AxisAlignedBox::new);
        triangle => |check| triangle::check(check, Triangle::new);
        nearest => |check| nearest::check(check, nearest);
        sphere => |check| sphere::check(check, Sphere::new);
        six_planes => |check| six_planes::check(check, SixPlanes::new);
    }
    solutions {
        signed_distance => |check| signed_distance::check(check, signed_distance);
        may_meet => |check| may_meet::check(check, may_meet);
        checkerboard => |check| checkerboard::check(check, checkerboard);
        cylinder => |check| cylinder::check(check, Cylinder::new);
        read_obj => |check| read_obj::check(check, read_obj);
        torus => |check| torus::check(check, Torus::new);
    }
}
