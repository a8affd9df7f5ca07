//! Checks the exercises of this stage, which the book sets.

mod barycentric;
mod length;
mod rotated;
mod stretched_normal;
mod triangle_area;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod barycentric;
    pub mod length;
    pub mod rotated;
    pub mod stretched_normal;
    pub mod triangle_area;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod barycentric;
    pub mod length;
    pub mod rotated;
    pub mod stretched_normal;
    pub mod triangle_area;
}

testing::exercises! {
    triangle_area, "The area of a triangle", 10 => |check| triangle_area::check(check, triangle_area);
    length, "Too long, too short", 10 => |check| length::check(check, length);
    barycentric, "Three corners, three shares", 20 => |check| barycentric::check(check, barycentric);
    rotated, "Round an axis", 20 => |check| rotated::check(check, rotated);
    stretched_normal, "A normal under stretch", 25 => |check| stretched_normal::check(check, stretched_normal);
}
