//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

mod lamps;
mod lit;
#[cfg(not(learn))]
#[path = "wrong/own.rs"]
mod own;
mod scene;

testing::exercises! {
    phong => |check| phong::check(check, Phong::new);
    point_light => |check| point_light::check(check, PointLight::new);
    directional_light => |check| directional_light::check(check, DirectionalLight::new);
    spot_light => |check| spot_light::check(check, SpotLight::new);
    lambert => |check| lambert::check(check, Lambert::new);
    fading_light => |check| fading_light::check(check, FadingLight::new);
    hemisphere => |check| hemisphere::check(check, Hemisphere::new);
    soft_spot => |check| soft_spot::check(check, SoftSpot::new);
    blinn_phong => |check| blinn_phong::check(check, BlinnPhong::new);
}
