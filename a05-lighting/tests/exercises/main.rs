//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod light;
mod material;
mod scene;

testing::exercises! {
    use {a02_math::*, a02_math::arrays::{point, vector}, a03_rays_cameras::*, a04_intersections::*, a05_lighting::*, common::*, a05_lighting::{scenes, stage}, crate::light::*, crate::material::*, crate::scene::*};
    starters {
        lambert => |check| lambert::check(check, &lambert);
        phong => |check| phong::check(check, &phong);
        point_light => |check| point_light::check(check, point_light);
        directional_light => |check| directional_light::check(check, directional_light);
        spot_light => |check| spot_light::check(check, &spot_light);
    }
    solutions {
        fading_light => |check| fading_light::check(check, fading_light);
        hemisphere => |check| hemisphere::check(check, &hemisphere);
        soft_spot => |check| soft_spot::check(check, soft_spot);
        blinn_phong => |check| blinn_phong::check(check, blinn_phong);
    }
}
