//! Checks the exercises of this stage, which the book sets.

mod fisheye;
mod mean;
mod radical_inverse;
mod rings;
mod thin_lens;

/// What students edit.
#[path = "../../exercises"]
#[allow(unused, clippy::all, clippy::pedantic)]
mod starters {
    pub mod fisheye;
    pub mod mean;
    pub mod radical_inverse;
    pub mod rings;
    pub mod thin_lens;
}

#[path = "../../exercises/solutions"]
mod solutions {
    pub mod fisheye;
    pub mod mean;
    pub mod radical_inverse;
    pub mod rings;
    pub mod thin_lens;
}

testing::exercises! {
    rings, "Rings in the sky", 10 => |check| rings::check(check, ring);
    mean, "A mean that does not drift", 15 => |check| mean::check(check, mean);
    radical_inverse, "Digits in the mirror", 15 => |check| radical_inverse::check(check, radical_inverse);
    fisheye, "Fisheye", 20 => |check| fisheye::check(check, Fisheye::new);
    thin_lens, "Out of focus", 30 => |check| thin_lens::check(check, through_lens);
}
