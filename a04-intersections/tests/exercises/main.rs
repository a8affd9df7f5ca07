//! Checks the exercises of this stage, which the book sets.

mod checkerboard;
mod cylinder;
mod may_meet;
mod read_obj;
mod shape;
mod signed_distance;
mod six_planes;
mod torus;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod checkerboard;
    pub mod cylinder;
    pub mod may_meet;
    pub mod read_obj;
    pub mod signed_distance;
    pub mod six_planes;
    pub mod torus;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod checkerboard;
    pub mod cylinder;
    pub mod may_meet;
    pub mod read_obj;
    pub mod signed_distance;
    pub mod six_planes;
    pub mod torus;
}

testing::exercises! {
    signed_distance, "On which side?", 10 => |check| signed_distance::check(check, signed_distance);
    may_meet, "A sphere around it all", 10 => |check| may_meet::check(check, may_meet);
    six_planes, "A box with two mistakes", 15 => |check| six_planes::check(check, SixPlanes::new);
    checkerboard, "Checkerboard", 20 => |check| checkerboard::check(check, checkerboard);
    cylinder, "Cylinder", 20 => |check| cylinder::check(check, Cylinder::new);
    read_obj, "A mesh from a file", 30 => |check| read_obj::check(check, read_obj);
    torus, "Torus", 40 => |check| torus::check(check, Torus::new);
}
