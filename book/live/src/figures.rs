//! The numbers behind the figures of the pages, each from the functions of its stage.
//!
//! A figure sends the numbers of its sliders and handles in a fixed order.

mod angle;
mod barycentric;
mod camera;
mod chain;
mod color;
mod hemisphere;
mod normals;
mod offset;
mod samples;
mod scene;
mod shading;
mod slabs;
mod sphere;
mod spot;
mod vectors;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::Error;

use crate::Answered;

/// Answers for the figure of this name.
pub fn answer(figure: &str, numbers: &[f64]) -> Answered {
    match figure {
        "color" => color::answer(expect(figure, numbers)?),
        "vectors" => Ok(vectors::answer(expect(figure, numbers)?)),
        "angle" => Ok(angle::answer(expect(figure, numbers)?)),
        "sphere" => sphere::answer(expect(figure, numbers)?),
        "camera" => camera::answer(expect(figure, numbers)?),
        "offset" => offset::answer(expect(figure, numbers)?),
        "lambert" => shading::lambert(expect(figure, numbers)?),
        "shading" => shading::answer(expect(figure, numbers)?),
        "hemisphere" => Ok(hemisphere::answer(expect(figure, numbers)?)),
        "samples" => Ok(samples::answer(expect(figure, numbers)?)),
        "sample-errors" => Ok(samples::errors(expect(figure, numbers)?)),
        "scene" => scene::answer(expect(figure, numbers)?),
        "slabs" => slabs::answer(expect(figure, numbers)?),
        "barycentric" => barycentric::answer(expect(figure, numbers)?),
        "spot" => spot::answer(expect(figure, numbers)?),
        "spaces" | "normals" => normals::answer(expect(figure, numbers)?),
        "chain" => chain::answer(expect(figure, numbers)?),
        _ => Err(Error::Usage(format!("there is no figure \"{figure}\""))),
    }
}

/// The numbers of a figure, if there are as many as it takes.
fn expect<const N: usize>(figure: &str, numbers: &[f64]) -> Result<[f64; N], Error> {
    let given = numbers.len();
    let wrong = format!("the figure {figure} takes {N} numbers, not {given}");
    numbers.try_into().map_err(|_| Error::Usage(wrong))
}

/// A point of a flat figure.
const fn point(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

/// A direction of a flat figure, from its angle to the right, in radians.
fn direction(angle: f64) -> Vector3 {
    Vector3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

/// The direction of a gaze, turned around the vertical and upwards, in radians.
fn gaze(around: f64, upwards: f64) -> Vector3 {
    let level = libm::cos(upwards);
    let (x, z) = (-libm::sin(around) * level, -libm::cos(around) * level);
    Vector3::new(x, libm::sin(upwards), z)
}

/// The first two coordinates.
fn flat(v: impl Direction) -> [f64; 2] {
    let along = |x, y| v.dot(Vector3::new(x, y, 0.0));
    [along(1.0, 0.0), along(0.0, 1.0)]
}

/// The first two coordinates of a point.
fn place(p: Point3) -> [f64; 2] {
    [p.x(), p.y()]
}

/// Both hits of a shape on the line of a ray, before and behind its origin; none
/// where it misses.
fn both_hits(shape: &impl Geometry, ray: &Ray) -> Vec<f64> {
    let mut line = Interval {
        min: f64::NEG_INFINITY,
        max: f64::INFINITY,
    };
    let mut hits = Vec::new();
    while let Some(hit) = shape.hit(ray, line).filter(|_| hits.len() < 2) {
        hits.push(hit.t);
        line.min = hit.t;
    }
    hits
}
