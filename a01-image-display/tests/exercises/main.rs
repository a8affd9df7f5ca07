//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod painted;

testing::exercises! {
    use {a01_image_display::*, common::*, crate::painted::*};
    starters {
        set_pixel => |check| set_pixel::check(check, &set_pixel);
        diagonal => |check| diagonal::check(check, &diagonal);
    }
    solutions {
        ppm => |check| ppm::check(check, &ppm);
        srgb => |check| srgb::check(check, encode, decode);
        line => |check| line::check(check, &line);
        thumbnail => |check| thumbnail::check(check, &thumbnail);
    }
}
