//! Accuracy of the formulas for far spheres.

use std::ops::RangeInclusive;
use std::rc::Rc;

use a02_math::Point3;
use a03_rays_cameras::Ray;
use measure::experiment::{Axis, Curve, Experiment, Slope, TaskSet, Unit};

use crate::formula::sphere::{SphereQuery, compensated, stable};
use crate::line::Line;
use crate::number::dot;
use crate::support::{Numbers, first, point};
use crate::{exact, protocol};
use a04_intersections::Sphere;

/// The `n`-th query of the unit sphere at the origin, from anywhere at a distance, at a disc of 1.2 radii.
fn from_afar(distance: f64, n: usize) -> SphereQuery {
    let mut numbers = Numbers::new(SEED, n);
    let [back, aside] = numbers.perpendicular();
    let from = back * distance;
    let target = aside * (1.2 * numbers.between(0.0, 1.0).sqrt());
    let towards = target - from;
    let unit = towards * (1.0 / towards.magnitude());
    SphereQuery {
        center: [0.0; 3],
        radius: 1.0,
        line: Line::of(&Ray::derived(Point3::ORIGIN + from, unit)),
    }
}

const SEED: u64 = 11;

/// The first queries from a distance.
pub fn queries(distance: f64, count: usize) -> Rc<[SphereQuery]> {
    (0..count).map(|n| from_afar(distance, n)).collect()
}

/// The error of a `t`, except near the rim of the sphere, where rounding of the ray itself
/// has an effect. A miss counts as 1.
fn error(query: &SphereQuery, found: Option<f64>) -> Option<f64> {
    let exact = exact::sphere(query);
    let [near, _] = exact.roots?;
    let is_near_the_rim = exact.distance >= 0.9 * query.radius;
    (!is_near_the_rim).then(|| found.map_or(1.0, |t| near.error_of(t)))
}

/// Whether a formula hits or misses the unit sphere wrongly, though the ray passes the rim at more
/// than four rounding errors of the numbers given.
pub fn is_wrong(query: &SphereQuery, found: Option<f64>) -> bool {
    let exact = exact::sphere(query);
    let origin = &query.line.origin;
    let margin = 4.0 * f64::EPSILON * dot(origin, origin).sqrt();
    let is_clear = (exact.distance - 1.0).abs() > margin;
    is_clear && found.is_some() != exact.roots.is_some()
}

/// A formula for the `t` of the nearest hit.
pub type Formula = fn(&SphereQuery) -> Option<f64>;

/// The renderer's sphere, with its constructor and the normal of the hit.
pub fn ours(query: &SphereQuery) -> Option<f64> {
    let sphere = Sphere::new(point(query.center), query.radius).ok()?;
    first(&sphere, &query.line.raw_ray())
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How far away may a sphere of radius 1 be?",
        parameter: "distance (radii)",
        work: "rays",
        against: Axis::Parameter,
        error: "rms error of t",
        unit: Unit::Other("radii"),
        exact: "against 30 digits; a miss counts as 1; seven of ten rays hit",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("sphere-far")
    }
}

/// The number of queries from each distance.
const COUNT: usize = 4096;

fn curves() -> Vec<Curve<'static>> {
    let mut sets = Vec::new();
    for power in 1..=10 {
        let parameter = libm::pow(8.0, power.into());
        sets.push(TaskSet {
            parameter,
            tasks: queries(parameter, COUNT),
        });
    }
    let curve = |method, formula: Formula, slope, between: RangeInclusive<f64>| Curve {
        slope: Some(Slope {
            value: slope,
            between,
        }),
        ..Curve::of_tasks(method, &sets, formula, error)
    };
    vec![
        // Beyond, it has no digit left.
        curve("protocol", protocol::sphere, 2.0, 8.0..=2e7),
        curve("stable (ours)", stable, 1.0, 8.0..=2e9),
        curve("compensated", compensated, 1.0, 8.0..=2e9),
    ]
}
