//! Checks the exercises of this stage, which the book sets.

mod fogged;
mod images;
mod reflectance;
mod refracted;
mod scene;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod fogged;
    pub mod images;
    pub mod reflectance;
    pub mod refracted;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod fogged;
    pub mod images;
    pub mod reflectance;
    pub mod refracted;
}

testing::exercises! {
    fogged, "Fog", 10 => |check| fogged::check(check, fogged);
    images, "Between two mirrors", 15 => |check| images::check(check, images);
    refracted, "Into the water", 25 => |check| refracted::check(check, refracted);
    reflectance, "How much water mirrors", 25 => |check| reflectance::check(check, reflectance);
}
