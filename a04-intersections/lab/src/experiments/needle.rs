//! Triangle tests on thinner and thinner triangles.

use std::rc::Rc;

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, Slope, TaskSet, Unit};

use crate::formula::triangle::{PlaneHit, fused, moeller_trumbore, watertight};
use crate::line::Line;
use crate::number::Triple;
use crate::support::{Numbers, first};
use crate::{exact, protocol};
use a04_intersections::Triangle;

/// A triangle and a ray. Half of the rays hit, far from grazing.
pub struct Needle {
    pub triangle: Triangle,
    pub ray: Ray,
    /// The corners of the triangle.
    points: [Point3; 3],
    /// Corners and ray as plain numbers.
    pub corners: [Triple; 3],
    pub line: Line,
}

/// Rays from 2 to 5 lengths away towards sixteen triangles with this ratio of length to
/// height, in various orientations.
pub fn needles(aspect: f64, rays: usize) -> Rc<[Needle]> {
    let mut needles = Vec::new();
    for n in 0..16 {
        let of_triangle = with_rays(n, aspect, rays / 16);
        needles.extend(of_triangle.unwrap_or_default());
    }
    needles.into()
}

/// The `n`-th triangle, with this number of rays.
fn with_rays(n: usize, aspect: f64, rays: usize) -> Result<Vec<Needle>, ArgumentError> {
    let mut numbers = Numbers::new(13, n);
    let [along, across] = numbers.perpendicular();
    let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let middle = along * numbers.between(0.3, 0.7);
    let height = across * (1.0 / aspect);
    // Longer than 1, so that the constructor accepts it.
    let points = [a, a + along, a + middle + height];
    let triangle = Triangle::new(points[0], points[1], points[2])?;
    let mut needles = Vec::new();
    for m in 0..rays {
        let mut numbers = Numbers::new(14 + n as u64, m);
        let (beta, gamma) = (numbers.between(0.0, 1.0), numbers.between(0.0, 1.0));
        let aim = along * beta + (middle + height) * gamma;
        let slanted = along.cross(across) + numbers.triple(-0.5, 0.5);
        let back = slanted * numbers.between(2.0, 5.0);
        let (origin, towards) = (a + aim + back, -back);
        let ray = Ray::derived(origin, towards * (1.0 / towards.magnitude()));
        needles.push(Needle {
            triangle,
            ray,
            points,
            corners: points.map(array),
            line: Line::of(&ray),
        });
    }
    Ok(needles)
}

/// The relative error of a `t`, if the exact barycentric coordinates are not near 0. A
/// miss counts as 1.
fn error(needle: &Needle, found: Option<f64>) -> Option<f64> {
    let PlaneHit { t, beta, gamma } = exact::triangle(&needle.corners, &needle.line);
    let [beta, gamma] = [beta.value(), gamma.value()];
    let least = beta.min(gamma).min(1.0 - beta - gamma);
    let error = found.map_or(1.0, |found| t.error_of(found) / t.value());
    (least > 0.05).then_some(error)
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How thin may a triangle be?",
        parameter: "length / height",
        work: "tests",
        against: Axis::Parameter,
        error: "rms error of t",
        unit: Unit::FractionOf("t"),
        exact: "against 30 digits, away from the edges; half of the rays hit",
        seeds: &[13, 14],
        curves: Box::new(curves),
        ..Experiment::new("triangle-needle")
    }
}

/// The number of rays at the needles of a ratio.
const RAYS: usize = 4096;

fn curves() -> Vec<Curve<'static>> {
    let mut sets = Vec::new();
    for power in 0..=9 {
        let parameter = libm::pow(8.0, power.into());
        sets.push(TaskSet {
            parameter,
            tasks: needles(parameter, RAYS),
        });
    }
    let curve = |method, formula: fn(&Needle) -> Option<f64>| {
        Curve::of_tasks(method, &sets, formula, error)
    };
    let slope = |value| {
        let between = 64.0..=2e8;
        Some(Slope { value, between })
    };
    vec![
        Curve {
            slope: slope(1.0),
            ..curve("Cramer (protocol)", |needle| {
                protocol::triangle(&needle.points, &needle.ray)
            })
        },
        Curve {
            slope: slope(1.0),
            ..curve("Möller-Trumbore", |needle| {
                moeller_trumbore(&needle.corners, &needle.line).hit()
            })
        },
        Curve {
            bound: Some(ErrorBound {
                error: 4.0 * f64::EPSILON,
                between: 1.0..=64.0,
            }),
            ..curve("Woop (ours)", |needle| first(&needle.triangle, &needle.ray))
        },
        Curve {
            slope: slope(0.0),
            ..curve("Woop (fused)", |needle| {
                watertight(&needle.corners, &needle.line, fused)
            })
        },
    ]
}
