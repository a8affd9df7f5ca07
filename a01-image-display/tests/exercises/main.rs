//! Checks the exercises of this stage, which the book sets.

mod line;
mod ppm;
mod srgb;
mod thumbnail;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod line;
    pub mod ppm;
    pub mod srgb;
    pub mod thumbnail;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod line;
    pub mod ppm;
    pub mod srgb;
    pub mod thumbnail;
}

testing::exercises! {
    ppm, "A file of your own", 10 => |check| ppm::check(check, ppm);
    srgb, "Half as bright", 15 => |check| srgb::check(check, encode, decode);
    line, "From corner to corner", 20 => |check| line::check(check, line);
    thumbnail, "Thumbnail", 25 => |check| thumbnail::check(check, thumbnail);
}
