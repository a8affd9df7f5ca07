//! Triangle tests on thinner and thinner triangles.

use std::rc::Rc;

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, ErrorBound, Experiment, Slope, TaskSet, Unit};

use crate::formula::triangle::{self, Meeting, Shot, watertight};
use crate::line::Line;
use crate::number::Real;
use crate::support::{Numbers, first};
use crate::{condition, exact, protocol};
use a04_intersections::Triangle;

/// A triangle and a ray. Half of the rays hit, far from grazing.
pub struct Needle {
    pub triangle: Triangle,
    /// Of the triangle.
    pub corners: [Point3; 3],
    pub ray: Ray,
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
    let corners = [a, a + along, a + middle + height];
    let triangle = Triangle::new(corners[0], corners[1], corners[2])?;
    let mut needles = Vec::new();
    for m in 0..rays {
        let mut numbers = Numbers::new(14 + n as u64, m);
        let (beta, gamma) = (numbers.between(0.0, 1.0), numbers.between(0.0, 1.0));
        let aim = along * beta + (middle + height) * gamma;
        let slanted = along.cross(across) + numbers.triple(-0.5, 0.5);
        let back = slanted * numbers.between(2.0, 5.0);
        let (origin, towards) = (a + aim + back, -back);
        needles.push(Needle {
            triangle,
            corners,
            ray: Ray::derived(origin, towards * (1.0 / towards.magnitude())),
        });
    }
    Ok(needles)
}

/// The numbers of triangle and ray, rounded to those of a type.
pub fn shot<F: Real>(needle: &Needle) -> Shot<F> {
    let shot = Shot {
        corners: needle.corners.map(array),
        line: Line::of(&needle.ray),
    };
    shot.to()
}

/// The relative error of a `t`, if the exact barycentric coordinates are not near 0. A
/// miss counts as 1.
fn error<F: Real>(shot: &Shot<F>, found: Option<F>) -> Option<Deviation> {
    let Shot { corners, line } = shot.in_doubles();
    let Meeting { t, beta, gamma } = exact::triangle(&corners, &line);
    let [beta, gamma] = [beta.value(), gamma.value()];
    let least = beta.min(gamma).min(1.0 - beta - gamma);
    if least <= 0.05 {
        return None;
    }
    let error = found.map_or(t.value(), |found| t.error_of(found.into()));
    let t = t.value();
    let condition = condition::of_triangle(&corners, beta, gamma, &line, t);
    let deviation = Deviation::new(error, t, condition).of_epsilon(F::EPSILON);
    Some(deviation.as_fraction_of(t))
}

/// The protocol's test.
fn cramer(needle: &Needle) -> Option<f64> {
    protocol::triangle(&needle.corners, &needle.ray)
}

/// The renderer's test.
fn ours(needle: &Needle) -> Option<f64> {
    first(&needle.triangle, &needle.ray)
}

/// The test of the exercise.
fn moeller_trumbore<F: Real>(Shot { corners, line }: &Shot<F>) -> Option<F> {
    triangle::moeller_trumbore(corners, line).hit()
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

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let rays = effort.choose(4096, 65_536);
    let (mut sets, mut doubles, mut singles) = (Vec::new(), Vec::new(), Vec::new());
    for power in 0..=9 {
        let parameter = libm::pow(8.0, power.into());
        let needles = needles(parameter, rays);
        doubles.push(TaskSet {
            parameter,
            tasks: needles.iter().map(shot::<f64>).collect(),
        });
        // In single precision the height of a thinner needle is a few roundings.
        if power <= 5 {
            singles.push(TaskSet {
                parameter,
                tasks: needles.iter().map(shot::<f32>).collect(),
            });
        }
        sets.push(TaskSet {
            parameter,
            tasks: needles,
        });
    }
    let of_needles = |method, formula: fn(&Needle) -> Option<f64>| {
        let error_of = |needle: &Needle, found| error::<f64>(&shot(needle), found);
        Curve::of_tasks(method, &sets, formula, error_of)
    };
    let of_doubles = |method, formula: fn(&Shot) -> Option<f64>| {
        Curve::of_tasks(method, &doubles, formula, error)
    };
    let of_singles = |method, formula: fn(&Shot<f32>) -> Option<f32>| {
        Curve::of_tasks(method, &singles, formula, error)
    };
    let slope = |value, most| {
        let between = 64.0..=most;
        Some(Slope { value, between })
    };
    vec![
        Curve {
            slope: slope(1.0, 2e8),
            ..of_needles("Cramer (protocol)", cramer)
        },
        Curve {
            slope: slope(1.0, 2e8),
            ..of_doubles("Möller-Trumbore", moeller_trumbore)
        },
        Curve {
            bound: Some(ErrorBound {
                error: 4.0 * f64::EPSILON,
                between: 1.0..=64.0,
            }),
            ..of_needles("Woop (ours)", ours)
        },
        Curve {
            slope: slope(0.0, 2e8),
            ..of_doubles("Woop (fused)", |shot| {
                watertight(&shot.corners, &shot.line, triangle::fused)
            })
        },
        Curve {
            slope: slope(0.0, 2e8),
            ..of_doubles("Woop (split)", |shot| {
                watertight(&shot.corners, &shot.line, triangle::split)
            })
        },
        Curve {
            slope: slope(1.0, 4e4),
            ..of_singles("Möller-Trumbore (single)", moeller_trumbore)
        },
        of_singles("Woop (single)", |shot| {
            watertight(&shot.corners, &shot.line, triangle::rounded)
        }),
    ]
}
