//! Triangle tests on thinner and thinner triangles.

use std::rc::Rc;

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, ErrorBound, Experiment, Slope, TaskSet, Unit};

use crate::formula::triangle::{self, Meeting};
use crate::line::Line;
use crate::support::{Numbers, corners, first};
use crate::{condition, exact, protocol};
use a04_intersections::Triangle;

/// A triangle and a ray. Half of the rays hit, far from grazing.
pub struct Needle {
    pub triangle: Triangle,
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
    let triangle = Triangle::new(a, a + along, a + middle + height)?;
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
            ray: Ray::derived(origin, towards * (1.0 / towards.magnitude())),
        });
    }
    Ok(needles)
}

/// The relative error of a `t`, if the exact barycentric coordinates are not near 0. A
/// miss counts as 1.
pub fn error(needle: &Needle, found: Option<f64>) -> Option<Deviation> {
    let line = Line::of(&needle.ray);
    let corners = corners(&needle.triangle).map(array);
    let Meeting { t, beta, gamma } = exact::triangle(&corners, &line);
    let [beta, gamma] = [beta.value(), gamma.value()];
    let least = beta.min(gamma).min(1.0 - beta - gamma);
    if least <= 0.05 {
        return None;
    }
    let error = found.map_or(t.value(), |found| t.error_of(found));
    let t = t.value();
    let condition = condition::of_triangle(&corners, beta, gamma, &line, t);
    Some(Deviation::new(error, t, condition).as_fraction_of(t))
}

/// A formula for the distance of the triangle along the ray.
pub type Formula = fn(&Needle) -> Option<f64>;

/// The protocol's test.
fn cramer(needle: &Needle) -> Option<f64> {
    protocol::triangle(&corners(&needle.triangle), &needle.ray)
}

/// The renderer's test.
fn ours(needle: &Needle) -> Option<f64> {
    first(&needle.triangle, &needle.ray)
}

fn moeller_trumbore(needle: &Needle) -> Option<f64> {
    let corners = corners(&needle.triangle).map(array);
    let line = Line::of(&needle.ray);
    // The coordinates of a ray along the plane are infinite or no numbers.
    let Meeting { t, beta, gamma } = triangle::moeller_trumbore(&corners, &line);
    let is_inside = (0.0..=1.0).contains(&beta) && gamma >= 0.0 && beta + gamma <= 1.0;
    (is_inside && t > 0.0).then_some(t)
}

/// The renderer's test with Kahan's difference of products, whose error is at most
/// 1.5 units in the last place (Jeannerod, Louvet and Muller, 2013).
fn compensated(needle: &Needle) -> Option<f64> {
    let ray = &needle.ray;
    let d = ray.direction().to_glam();
    let z = d.abs().max_position();
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let [a, b, c] = corners(&needle.triangle).map(|corner| {
        let p = (corner - ray.origin()).to_glam();
        [
            p[x] - d[x] / d[z] * p[z],
            p[y] - d[y] / d[z] * p[z],
            p[z] * (1.0 / d[z]),
        ]
    });
    let area = |p: [f64; 3], q: [f64; 3]| difference_of_products(p[0], q[1], p[1], q[0]);
    let [u, v, w] = [area(c, b), area(a, c), area(b, a)];
    let is_inside = u.min(v).min(w) >= 0.0 || u.max(v).max(w) <= 0.0;
    let t = (u * a[2] + v * b[2] + w * c[2]) / (u + v + w);
    (is_inside && t > 0.0).then_some(t)
}

/// `a b - c d`, where the rounding error of `c d` is added again.
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two is what the method lives on"
)]
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    let difference = a.mul_add(b, -product);
    let error = (-c).mul_add(d, product);
    difference + error
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How thin may a triangle be?",
        parameter: "length / height",
        work: "tests",
        against: Axis::Parameter,
        error: "rms error of t",
        unit: Unit::Other("fraction of t"),
        exact: "against 30 digits, away from the edges; half of the rays hit",
        seeds: &[13, 14],
        curves: Box::new(curves),
        ..Experiment::new("triangle-needle")
    }
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let rays = effort.choose(4096, 65_536);
    let mut sets = Vec::new();
    for power in 0..=9 {
        let aspect = libm::pow(8.0, power.into());
        sets.push(TaskSet {
            parameter: aspect,
            tasks: needles(aspect, rays),
        });
    }
    let curve = |method, formula: Formula| Curve::of_tasks(method, &sets, formula, error);
    let slope = |value| {
        let between = 64.0..=2e8;
        Some(Slope { value, between })
    };
    vec![
        Curve {
            slope: slope(1.0),
            ..curve("Cramer (protocol)", cramer)
        },
        Curve {
            slope: slope(1.0),
            ..curve("Moeller-Trumbore", moeller_trumbore)
        },
        Curve {
            bound: Some(ErrorBound {
                error: 4.0 * f64::EPSILON,
                between: 1.0..=64.0,
            }),
            ..curve("Woop (ours)", ours)
        },
        Curve {
            slope: slope(0.0),
            ..curve("Woop (compensated)", compensated)
        },
    ]
}
