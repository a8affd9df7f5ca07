//! Checks the exercises of this stage, which the book sets.

mod blinn_phong;
mod fading_light;
mod hemisphere;
mod scene;
mod soft_spot;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod blinn_phong;
    pub mod fading_light;
    pub mod hemisphere;
    pub mod soft_spot;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod blinn_phong;
    pub mod fading_light;
    pub mod hemisphere;
    pub mod soft_spot;
}

testing::exercises! {
    fading_light, "A lamp that fades", 10 => |check| fading_light::check(check, FadingLight::new);
    hemisphere, "Sky and ground", 10 => |check| hemisphere::check(check, Hemisphere::new);
    soft_spot, "A soft rim", 20 => |check| soft_spot::check(check, SoftSpot::new);
    blinn_phong, "Half way", 25 => |check| blinn_phong::check(check, BlinnPhong::new);
}
