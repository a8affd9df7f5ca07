//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod drawn;
#[path = "../../src/scenes.rs"]
mod scenes;

// The types that `scenes` takes from its crate.
use a02_math::Normal3;
use drawn::Vector3;

testing::exercises! {
    use {a02_math::*, a02_math::arrays::{point, vector}, common::*, crate::drawn::scene};
    starters {
        products => |check| products::check(check, dot, cross);
        angle => |check| angle::check(check, angle);
        reflected => |check| reflected::check(check, reflected);
    }
    solutions {
        triangle_area => |check| triangle_area::check(check, triangle_area);
        length => |check| length::check(check, &length);
        barycentric => |check| barycentric::check(check, barycentric);
        rotated => |check| rotated::check(check, rotated);
        stretched_normal => |check| stretched_normal::check(check, stretched_normal);
    }
}
