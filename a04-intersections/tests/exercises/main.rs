//! Checks the exercises of this stage, which the book sets.

mod cylinder;
mod signed_distance;
mod solid;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::pedantic)]
mod starters {
    pub mod cylinder;
    pub mod signed_distance;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod cylinder;
    pub mod signed_distance;
}

common::exercises! {
    signed_distance, "On which side?", 10 => |check| signed_distance::check(check, signed_distance);
    cylinder, "Cylinder", 20 => |check| cylinder::check(check, Cylinder::new);
}
