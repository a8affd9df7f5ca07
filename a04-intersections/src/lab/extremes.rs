//! Stiff and extreme cases of rays and shapes. Exact values were computed with
//! mpmath at 1200 bits from the doubles given, or follow from closed forms.
//!
//! Tables are formatted by hand, with one row on a line.

mod axis_aligned_box;
mod color;
mod leaks;
mod place;
mod plane;
mod precision;
mod sphere;
mod triangle;

pub use a02_math::lab::extremes::{point, vector};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::{Case, Outcome};

use crate::{Geometry, Interval};

pub fn cases(effort: Effort) -> Vec<Case> {
    let fixed = [
        sphere::cases,
        axis_aligned_box::cases,
        triangle::cases,
        color::cases,
    ];
    let random = [plane::cases, place::cases, leaks::cases, precision::cases];
    let mut cases = fixed.map(|cases| cases()).concat();
    cases.extend(random.map(|cases| cases(effort)).concat());
    cases.sort_by_key(|case| case.id);
    cases
}

const MISS: Outcome = Outcome::Nothing;
const REFUSED: Outcome = Outcome::Refused;
const EPSILON: f64 = f64::EPSILON;

pub type Triple = [f64; 3];
/// An origin and a direction.
pub type Line = (Triple, Triple);

/// The ray as in a scene, with a direction of length 1.
fn unit_ray((o, d): Line) -> Result<Ray, ArgumentError> {
    Ray::new(point(o), vector(d))
}

/// The ray as in the protocol: unchecked.
pub const fn raw_ray((o, d): Line) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The ray as in a scene, or unchecked if `Ray::new` refuses it.
fn any_ray(line: Line) -> Ray {
    unit_ray(line).unwrap_or(raw_ray(line))
}

/// Origin and direction as arrays, the arguments of formulas in both precisions.
pub fn arrays(ray: &Ray) -> [Triple; 2] {
    [ray.origin().to_glam(), ray.direction().to_glam()].map(|v| v.to_array())
}

/// The `t` of a ray's nearest hit of a shape.
pub fn first(shape: &impl Geometry, ray: &Ray) -> Option<f64> {
    shape.hit(ray, Interval::AHEAD).map(|hit| hit.t)
}

/// The `t` of the nearest hit as an outcome, or the error of a constructor.
fn meeting<G: Geometry>(shape: Result<G, ArgumentError>, line: Line) -> Outcome {
    let met = || Ok::<_, ArgumentError>(first(&shape?, &unit_ray(line)?));
    met().into()
}
