//! Checks the exercises of this stage, which the book sets.

mod orbits;
mod ring;
mod rotation;
mod shape;
mod sheared;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod orbits;
    pub mod ring;
    pub mod rotation;
    pub mod sheared;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod orbits;
    pub mod ring;
    pub mod rotation;
    pub mod sheared;
}

testing::exercises! {
    ring, "Ring", 10 => |check| ring::check(check, Ring::new);
    orbits, "Earth and moon", 15 => |check| orbits::check(check, orbits);
    sheared, "A shape that leans", 20 => |check| sheared::check(check, Sheared::new, Sheared::new);
    rotation, "About any axis", 30 => |check| rotation::check(check, rotation);
}
