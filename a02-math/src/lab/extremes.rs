//! Stiff and extreme cases of vectors, angles and linear systems. Exact values
//! are computed from the given doubles, with 60 digits or with fractions.

mod angles;
mod lengths;
mod systems;

use measure::Effort;
use measure::extremes::{Case, Outcome};

use crate::{Normal3, Point3, Vector3};

pub fn cases(_: Effort) -> Vec<Case> {
    [lengths::cases(), angles::cases(), systems::cases()].concat()
}

pub const fn vector([x, y, z]: [f64; 3]) -> Vector3 {
    Vector3::new(x, y, z)
}

pub const fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

impl From<Vector3> for Outcome {
    fn from(v: Vector3) -> Self {
        v.to_glam().to_array().into()
    }
}

impl From<Normal3> for Outcome {
    fn from(n: Normal3) -> Self {
        n.to_glam().to_array().into()
    }
}

impl From<Point3> for Outcome {
    fn from(p: Point3) -> Self {
        p.to_glam().to_array().into()
    }
}
