//! Accuracy of the formulas for far spheres and for huge spheres.

use std::ops::RangeInclusive;
use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Slope, TaskSet, Unit};

use crate::formula::sphere::{Shot, compensated, stable};
use crate::line::Line;
use crate::number::{Real, Triple, dot};
use crate::support::{Numbers, first, point};
use crate::{condition, exact, protocol};
use a04_intersections::Sphere;

/// The `n`-th shot of a parameter.
pub type Shots = fn(parameter: f64, n: usize) -> Shot;

/// The shot from a point in a direction that is normalised.
fn shot(center: Triple, radius: f64, from: Vector3, direction: Vector3) -> Shot {
    let unit = direction * (1.0 / direction.magnitude());
    let ray = Ray::derived(Point3::ORIGIN + from, unit);
    Shot {
        center,
        radius,
        line: Line::of(&ray),
    }
}

/// The unit sphere at the origin and rays from all around, at a distance, that
/// aim at a disc of 1.2 radii.
pub fn from_afar(distance: f64, n: usize) -> Shot {
    let mut numbers = Numbers::new(11, n);
    let [back, aside] = numbers.perpendicular();
    let from = back * distance;
    let target = aside * (1.2 * numbers.between(0.0, 1.0).sqrt());
    shot([0.0; 3], 1.0, from, target - from)
}

/// A sphere of this radius whose top is the origin, such as a ground, and rays from
/// one to two units above it, three of four of them downwards.
pub fn at_ground(radius: f64, n: usize) -> Shot {
    let mut numbers = Numbers::new(12, n);
    let aside = numbers.triple(-1.0, 1.0);
    let from = Vector3::new(aside.x(), numbers.between(1.0, 2.0), aside.z());
    let down = if numbers.below(4) == 0 { 1.0 } else { -1.0 };
    let mut slope = || numbers.between(-0.5, 0.5);
    let direction = Vector3::new(slope(), down, slope());
    shot([0.0, -radius, 0.0], radius, from, direction)
}

/// The first shots of a parameter in either precision.
pub fn shots<F: Real>(shots: Shots, parameter: f64, count: usize) -> Rc<[Shot<F>]> {
    (0..count).map(|n| shots(parameter, n).to()).collect()
}

/// The error of a `t`, except near the rim of the sphere, where rounding of the ray itself
/// has an effect. A miss counts as 1.
pub fn error<F: Real>(shot: &Shot<F>, found: Option<F>) -> Option<Deviation> {
    let shot = shot.in_doubles();
    let exact = exact::sphere(&shot);
    let [near, _] = exact.roots?;
    let is_near_the_rim = exact.distance >= 0.9 * shot.radius;
    if is_near_the_rim || near.value() <= 0.0 {
        return None;
    }
    let error = found.map_or(1.0, |t| near.error_of(t.into()));
    let t = near.value();
    let condition = condition::of_sphere(&shot.center, shot.radius, &shot.line, t);
    Some(Deviation::new(error, t, condition).of_epsilon(F::EPSILON))
}

/// Whether a formula hits or misses the unit sphere wrongly, though the ray passes the rim at more
/// than four rounding errors of the numbers given.
pub fn is_wrong<F: Real>(shot: &Shot<F>, found: Option<F>) -> bool {
    let shot = shot.in_doubles();
    let exact = exact::sphere(&shot);
    let origin = &shot.line.origin;
    let margin = 4.0 * F::EPSILON * dot(origin, origin).sqrt();
    let is_clear = (exact.distance - 1.0).abs() > margin;
    is_clear && found.is_some() != exact.roots.is_some()
}

/// A formula for the `t` of the nearest hit.
pub type Formula<F> = fn(&Shot<F>) -> Option<F>;

/// The renderer's sphere, with its constructor and the normal of the hit.
pub fn ours(shot: &Shot) -> Option<f64> {
    let sphere = Sphere::new(point(shot.center), shot.radius).ok()?;
    first(&sphere, &shot.line.raw_ray())
}

/// The first powers of 8, each with its shots.
fn sets<F: Real>(of: Shots, powers: i32, effort: Effort) -> Vec<TaskSet<Shot<F>>> {
    let count = effort.choose(4096, 65_536);
    let mut sets = Vec::new();
    for power in 1..=powers {
        let parameter = libm::pow(8.0, power.into());
        sets.push(TaskSet {
            parameter,
            tasks: shots(of, parameter, count),
        });
    }
    sets
}

fn curve<F: Real + 'static>(
    method: &'static str,
    sets: &[TaskSet<Shot<F>>],
    formula: Formula<F>,
) -> Curve<'static> {
    Curve::of_tasks(method, sets, formula, error)
}

/// What theory says about the errors of shots.
struct Theory {
    shots: Shots,
    /// The number of powers of 8 that single precision can tell apart.
    powers_of_singles: i32,
    /// The slopes of the protocol's formula and of the compensated one; that of ours is 1.
    slope_of_protocol: f64,
    slope_of_compensated: f64,
    /// Where the protocol's slope holds: beyond, it has no digit left.
    until_lost: RangeInclusive<f64>,
    /// Where the other slopes hold.
    everywhere: RangeInclusive<f64>,
    /// Where all slopes hold in single precision.
    single: RangeInclusive<f64>,
}

impl Theory {
    /// All formulas, in doubles and in single precision.
    fn curves(&self, effort: Effort) -> Vec<Curve<'static>> {
        let doubles = sets::<f64>(self.shots, 10, effort);
        let singles = sets::<f32>(self.shots, self.powers_of_singles, effort);
        let slope = |value, between: &RangeInclusive<f64>| {
            let between = between.clone();
            Some(Slope { value, between })
        };
        vec![
            Curve {
                slope: slope(self.slope_of_protocol, &self.until_lost),
                ..curve("protocol", &doubles, protocol::sphere)
            },
            Curve {
                slope: slope(1.0, &self.everywhere),
                ..curve("stable (ours)", &doubles, stable)
            },
            Curve {
                slope: slope(self.slope_of_compensated, &self.everywhere),
                ..curve("compensated", &doubles, compensated)
            },
            Curve {
                slope: slope(self.slope_of_protocol, &self.single),
                ..curve("protocol (single)", &singles, protocol::sphere)
            },
            Curve {
                slope: slope(1.0, &self.single),
                ..curve("stable (single)", &singles, stable)
            },
        ]
    }
}

pub fn far() -> Experiment<'static> {
    let theory = Theory {
        shots: from_afar,
        powers_of_singles: 3,
        slope_of_protocol: 2.0,
        slope_of_compensated: 1.0,
        until_lost: 8.0..=2e7,
        everywhere: 8.0..=2e9,
        single: 8.0..=512.0,
    };
    Experiment {
        question: "How far away may a sphere of radius 1 be?",
        parameter: "distance (radii)",
        work: "rays",
        against: Axis::Parameter,
        error: "rms error of t",
        unit: Unit::Other("radii"),
        exact: "against 30 digits; a miss counts as 1; seven of ten rays hit",
        seeds: &[11],
        curves: Box::new(move |effort| theory.curves(effort)),
        ..Experiment::new("sphere-far")
    }
}

pub fn near() -> Experiment<'static> {
    let theory = Theory {
        shots: at_ground,
        powers_of_singles: 6,
        slope_of_protocol: 1.0,
        slope_of_compensated: 0.0,
        until_lost: 64.0..=2e9,
        everywhere: 64.0..=2e9,
        single: 64.0..=3e5,
    };
    Experiment {
        question: "How large may a sphere be whose surface is near the eye?",
        parameter: "radius (eye heights)",
        work: "rays",
        against: Axis::Parameter,
        error: "rms error of t",
        unit: Unit::Other("heights of the eye"),
        exact: "against 30 digits; three of four rays hit",
        seeds: &[12],
        curves: Box::new(move |effort| theory.curves(effort)),
        ..Experiment::new("sphere-near")
    }
}
