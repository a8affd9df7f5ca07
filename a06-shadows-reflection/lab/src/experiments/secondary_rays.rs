//! Wrong decisions of rays that leave a surface: acne, where it shades itself, and leaks, where
//! a ray passes through an object near it.

use std::ops::RangeInclusive;
use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a04_lab::support::Numbers;
use common::Error;
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, TaskSet, Unit};

use crate::lit_points::{AIM, Aim, EyeRay, LitPoint, SEED, eye_rays, from_eye_rays};
use crate::policy::{Policy, above_a_thousandth, above_zero, offset, relative_to_t};
use crate::surface::{SHAPES, Shape, cuboid, plane, sphere, triangle};

pub fn experiments() -> Vec<Experiment<'static>> {
    [
        WrongDecisions {
            name: "acne",
            opposite: "leaks",
            question: "Which rays keep a surface out of its own shadow?",
            error: "fraction of shadow rays that hit their own surface",
            exact: "where light arrives; beds 1 to 8: scenes of 1e-6 to 1e9 units; 9: large shapes; 10: needles; 11: seen from afar",
            wrong: |lit, policy| f64::from(lit.shades_itself(policy)),
            promised: 1.0..=11.0,
        },
        WrongDecisions {
            name: "leaks",
            opposite: "acne",
            question: "Which rays find an object near the surface?",
            error: "fraction of shadow rays that miss an object",
            exact: "1e-4 or 1e-9 sizes away, in the beds of acne",
            wrong: |lit, policy| {
                let leaks = NEAR.map(|near| f64::from(lit.leaks(policy, near)));
                leaks.iter().sum::<f64>() / NEAR.len() as f64
            },
            // Of large shapes, of needles and from afar the offset is longer than the nearer distance.
            promised: 1.0..=8.0,
        },
    ]
    .map(WrongDecisions::experiment)
    .into()
}

/// An experiment on a kind of wrong decision: the shape is convex and the light outside, but a ray to
/// it hits the shape; or a ray to the light misses an object at one of the distances [`NEAR`].
struct WrongDecisions {
    name: &'static str,
    /// The experiment with the opposite mistake at the same points.
    opposite: &'static str,
    question: &'static str,
    error: &'static str,
    exact: &'static str,
    /// The fraction of wrong decisions for a point and a policy.
    wrong: fn(&LitPoint, Policy) -> f64,
    /// The beds at which our rays are never wrong.
    promised: RangeInclusive<f64>,
}

/// A rule for rays that leave a hit, with its name.
struct Method {
    name: &'static str,
    policy: Policy,
}

/// Distances of an object before the light, in sizes of the scene.
pub const NEAR: [f64; 2] = [1e-4, 1e-9];

/// The rules that are compared, ours at the end.
const METHODS: [Method; 4] = [
    Method {
        name: "above 1e-3 (protocol)",
        policy: above_a_thousandth,
    },
    Method {
        name: "above 0",
        policy: above_zero,
    },
    Method {
        name: "above 2e-12 t (pbrt 2)",
        policy: relative_to_t,
    },
    Method {
        name: "offset (ours)",
        policy: offset,
    },
];

impl WrongDecisions {
    fn experiment(self) -> Experiment<'static> {
        let name = self.name;
        Experiment {
            question: self.question,
            parameter: "test bed",
            work: "shadow rays",
            against: Axis::Parameter,
            error: self.error,
            unit: Unit::Fraction,
            exact: self.exact,
            opposite: Some(self.opposite),
            seeds: &[SEED],
            curves: Box::new(move || self.curves()),
            ..Experiment::new(name)
        }
    }

    fn curves(&self) -> Vec<Curve<'static>> {
        let (beds, wrong) = (beds(), self.wrong);
        let mut curves = Vec::new();
        for Method { name, policy } in METHODS {
            let shades_itself = move |lit: &LitPoint| lit.shades_itself(policy);
            let wrong = move |lit: &LitPoint, _| wrong(lit, policy);
            curves.push(Curve::of_decisions(name, &beds, shades_itself, wrong));
        }
        if let Some(ours) = curves.last_mut() {
            ours.bound = Some(ErrorBound {
                error: 0.0,
                between: self.promised.clone(),
            });
        }
        curves
    }
}

/// The sizes of the first scenes, in units.
const SIZES: [f64; 8] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9];

/// The number of rays for each shape.
const COUNT: usize = 1_024;

/// How large, thin or far the hard shapes are.
const HARD: f64 = 1e6;

/// The test beds by their numbers. Beds 1 to 8 are scenes of the [`SIZES`]; in bed 9 shapes are a million
/// times as large as the view, in bed 10 triangles are needles, and in bed 11 the eye is a million sizes
/// away.
fn beds() -> Vec<TaskSet<LitPoint>> {
    let mut beds = Vec::new();
    for size in SIZES {
        beds.push(points(&SHAPES, size, size, AIM));
    }
    // From above a surface through the origin.
    let above = Aim {
        middle: [0.0, 6.0, 0.0],
        distance: 5.0,
        within: 7.0,
    };
    beds.push(points(&LARGE, HARD, 1.0, above));
    let needles = from_eye_rays(COUNT, SEED, 1.0, |numbers| needle(numbers, HARD));
    beds.push(needles.unwrap_or_default().into());
    let afar = Aim {
        distance: HARD,
        ..AIM
    };
    beds.push(points(&SHAPES, 1.0, 1.0, afar));
    let numbered = (1..).zip(beds);
    let numbered = numbered.map(|(number, tasks)| TaskSet {
        parameter: f64::from(number),
        tasks,
    });
    numbered.collect()
}

/// A ray from the eye to a point of a needle, which leans or lies along an axis.
fn needle(numbers: &mut Numbers, aspect: f64) -> Result<EyeRay, Error> {
    let (mut along, mut across) = (numbers.direction(), numbers.direction());
    if numbers.below(2) == 0 {
        along = Vector3::new(1.0, 0.0, 0.0);
        across = Vector3::new(0.0, 0.0, 1.0);
    }
    let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let tip = along * numbers.between(0.0, 1.0) + across * (1.0 / aspect);
    let (beta, gamma) = (numbers.between(0.0, 0.5), numbers.between(0.0, 0.5));
    let target = a + along * beta + tip * gamma;
    let eye = target + numbers.direction() * 3.0;
    Ok(EyeRay {
        surface: triangle([a, a + along, a + tip])?,
        eye,
        target,
    })
}

/// Lit points of some shapes of a size in a scene of a size; none where a shape fails.
fn points(shapes: &[Shape], size: f64, scene: f64, aim: Aim) -> Rc<[LitPoint]> {
    let mut points = Vec::new();
    for shape in shapes {
        let of_shape = eye_rays(*shape, size, scene, aim)
            .and_then(|eye_ray| from_eye_rays(COUNT, SEED, scene, eye_ray));
        match of_shape {
            Ok(of_shape) => points.extend(of_shape),
            Err(_) => return Rc::new([]),
        }
    }
    points.into()
}

/// Surfaces through the origin, of shapes of any size: slanted, and perpendicular to an axis.
const LARGE: [Shape; 6] = [
    |r| sphere(Point3::ORIGIN - NORMAL * r, r),
    |r| plane(Point3::ORIGIN + ALONG * r, NORMAL.as_normal()),
    |r| {
        let up = Vector3::new(0.0, 1.0, 0.0);
        plane(Point3::new(r, 0.0, r), up.as_normal())
    },
    |r| cuboid(Point3::new(-r, -r, -r), Point3::new(r, 0.1, r)),
    |r| {
        let corners = [ALONG - ACROSS, ALONG + ACROSS, ALONG * -2.0];
        triangle(corners.map(|v| Point3::ORIGIN + v * (20.0 * r)))
    },
    |r| {
        let corners = [[-20.0, -20.0], [20.0, -20.0], [0.0, 20.0]];
        triangle(corners.map(|[x, z]| Point3::new(x * r, 0.0, z * r)))
    },
];

/// Three directions at right angles.
const NORMAL: Vector3 = Vector3::new(2.0 / 7.0, 6.0 / 7.0, 3.0 / 7.0);
const ALONG: Vector3 = Vector3::new(6.0 / 7.0, -3.0 / 7.0, 2.0 / 7.0);
const ACROSS: Vector3 = Vector3::new(3.0 / 7.0, 2.0 / 7.0, -6.0 / 7.0);
