//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod scene;
mod traced;

testing::exercises! {
    shadowed => |check| shadowed::check(check, is_shadowed);
    leaving => |check| leaving::check(check, secondary_ray);
    mirror => |check| mirror::check(check, trace);
    fogged => |check| fogged::check(check, fogged);
    images => |check| images::check(check, images);
    refracted => |check| refracted::check(check, refracted);
    reflectance => |check| reflectance::check(check, reflectance);
}
