//! Wrong decisions of rays that leave a surface: acne, where it shades itself, and leaks, where
//! a ray passes through an object near it.

use std::ops::RangeInclusive;
use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a04_lab::support::Numbers;
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use crate::lit_points::{AIM, Aim, Look, SEED, Trial, looks, trials};
use crate::policy::{OFFSET, PUT_BACK, Policy, RELATIVE, STEPPED, THOUSANDTH};
use crate::surface::{SHAPES, Shape, cuboid, plane, sphere, triangle};

pub fn experiments() -> Vec<Experiment<'static>> {
    let size = "scene size (units)";
    let ratio = "size of the shape (sizes of the view)";
    let distance = "distance of the eye (sizes of the scene)";
    let aspect = "longest edge / least height";
    vec![
        acne("acne", "Which rays keep a surface out of its own shadow?").over(size, by_size),
        leaks("leaks", "Which rays find an object near the surface?").over(size, by_size),
        acne("acne-of-large-shapes", "How large may a shape be?").over(ratio, by_ratio),
        acne("acne-from-afar", "From how far away may the eye look?").over(distance, by_distance),
        Wrong {
            // The offset is 1e-9 sizes at a distance of 7e4.
            promised: 0.0..=1e4,
            ..leaks("leaks-from-afar", "How far away may the eye be?")
        }
        .over(distance, by_distance),
        acne("acne-of-needles", "How thin may a triangle be?").over(aspect, by_aspect),
    ]
}

/// Values of the parameter, each with lit points.
pub type Sets = Vec<(f64, Rc<[Trial]>)>;

/// An experiment on a kind of wrong decision.
pub struct Wrong {
    pub experiment: Experiment<'static>,
    /// The fraction of wrong decisions for a point and a policy.
    pub wrong: fn(&Trial, Policy) -> f64,
    /// The policies that are compared, ours at the end.
    pub policies: &'static [(&'static str, Policy)],
    /// The parameters at which our rays are never wrong.
    pub promised: RangeInclusive<f64>,
}

/// The shape is convex and the light outside, but a ray to it hits the shape.
pub fn acne(name: &'static str, question: &'static str) -> Wrong {
    let experiment = Experiment::new(name)
        .asking(question)
        .with_error("fraction of shadow rays that hit their own surface")
        .with_exact("where light arrives");
    Wrong {
        experiment,
        wrong: |trial, policy| f64::from(trial.shades_itself(policy)),
        policies: &POLICIES,
        promised: 0.0..=f64::INFINITY,
    }
}

/// A ray to the light misses an object at one of the distances `NEAR`.
pub fn leaks(name: &'static str, question: &'static str) -> Wrong {
    let experiment = Experiment::new(name)
        .asking(question)
        .with_error("fraction of shadow rays that miss an object")
        .with_exact("1e-4 or 1e-9 sizes away");
    Wrong {
        experiment,
        wrong: |trial, policy| {
            let leaks = NEAR.map(|near| f64::from(trial.leaks(policy, near)));
            leaks.iter().sum::<f64>() / NEAR.len() as f64
        },
        policies: &POLICIES,
        promised: 0.0..=f64::INFINITY,
    }
}

/// Distances of an object before the light, in sizes of the scene.
const NEAR: [f64; 2] = [1e-4, 1e-9];

/// A name and the rule for rays that leave a hit.
const POLICIES: [(&str, Policy); 7] = [
    ("above 1e-3 (protocol)", THOUSANDTH),
    ("above 0", ABOVE_ZERO),
    ("above 1e-6", ABOVE_A_MILLIONTH),
    ("above 1e-9 of the largest", RELATIVE),
    ("steps of doubles", STEPPED),
    ("put back", PUT_BACK),
    ("offset (ours)", OFFSET),
];

/// Those for shapes that cannot put a point back.
pub const FOR_EVERY_SHAPE: [(&str, Policy); 6] = [
    ("above 1e-3 (protocol)", THOUSANDTH),
    ("above 0", ABOVE_ZERO),
    ("above 1e-6", ABOVE_A_MILLIONTH),
    ("above 1e-9 of the largest", RELATIVE),
    ("steps of doubles", STEPPED),
    ("offset (ours)", OFFSET),
];

const ABOVE_ZERO: Policy = |trial| trial.from_point(0.0);
const ABOVE_A_MILLIONTH: Policy = |trial| trial.from_point(1e-6);

impl Wrong {
    /// The experiment over a parameter.
    pub fn over(self, parameter: &'static str, sets: fn(Effort) -> Sets) -> Experiment<'static> {
        let Self {
            experiment,
            wrong,
            policies,
            promised,
        } = self;
        let experiment = experiment.over(Axis::Parameter, parameter, "shadow rays");
        let experiment = experiment.with_unit(Unit::Share).with_seeds(&[SEED]);
        experiment.with_curves(move |effort| {
            let sets = sets(effort);
            let mut curves = Vec::new();
            for &(method, policy) in policies {
                let run = move |trial: &Trial| trial.shades_itself(policy);
                let wrong = move |trial: &Trial, _| wrong(trial, policy);
                curves.push(Curve::of_decisions(method, &sets, run, wrong));
            }
            if let Some(ours) = curves.pop() {
                curves.push(ours.with_bound(0.0, promised.clone()));
            }
            curves
        })
    }
}

fn by_size(effort: Effort) -> Sets {
    let sizes = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9];
    let set = |size| (size, points(&SHAPES, [size; 2], AIM, effort));
    sizes.map(set).into()
}

/// From above a surface through the origin.
const ABOVE: Aim = ([0.0, 6.0, 0.0], [5.0, 7.0]);

fn by_ratio(effort: Effort) -> Sets {
    let ratios = [1.0, 1e1, 1e2, 1e3, 1e4, 1e6, 1e9];
    let set = |ratio| (ratio, points(&LARGE, [ratio, 1.0], ABOVE, effort));
    ratios.map(set).into()
}

fn by_distance(effort: Effort) -> Sets {
    let (middle, [_, within]) = AIM;
    let set = |distance| {
        let aim = (middle, [distance, within]);
        (distance, points(&SHAPES, [1.0; 2], aim, effort))
    };
    [5.0, 1e2, 1e4, 1e6, 1e8].map(set).into()
}

fn by_aspect(effort: Effort) -> Sets {
    let set = |aspect| {
        let count = effort.choose(1_024, 16_384);
        let points = trials(count, SEED, 1.0, move |numbers| needle(numbers, aspect));
        (aspect, points.unwrap_or_default().into())
    };
    [1.0, 1e2, 1e4, 1e6, 1e8, 1e10].map(set).into()
}

/// A look at a point of a needle, which leans or lies along an axis.
fn needle(numbers: &mut Numbers, aspect: f64) -> Result<Look, Error> {
    let (mut along, mut across) = (numbers.direction(), numbers.direction());
    if numbers.below(2) == 0 {
        (along, across) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
    }
    let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let tip = along * numbers.between(0.0, 1.0) + across * (1.0 / aspect);
    let (beta, gamma) = (numbers.between(0.0, 0.5), numbers.between(0.0, 0.5));
    let target = a + along * beta + tip * gamma;
    let eye = target + numbers.direction() * 3.0;
    Ok((triangle([a, a + along, a + tip])?, [eye, target]))
}

/// Lit points of some shapes of a size in a scene of a size; none where a shape fails.
pub fn points(shapes: &[Shape], [size, scene]: [f64; 2], aim: Aim, effort: Effort) -> Rc<[Trial]> {
    let count = effort.choose(1_024, 16_384);
    let of_shape = |shape: &Shape| {
        let look = looks(*shape, size, scene, aim)?;
        trials(count, SEED, scene, look)
    };
    let points = shapes
        .iter()
        .map(of_shape)
        .collect::<Result<Vec<_>, Error>>();
    points.unwrap_or_default().into_iter().flatten().collect()
}

/// Surfaces through the origin, of shapes of any size: slanted, and perpendicular to an axis.
#[rustfmt::skip]
const LARGE: [Shape; 6] = [
    |r| sphere(Point3::ORIGIN - NORMAL * r, r),
    |r| plane(Point3::ORIGIN + ALONG * r, NORMAL.as_normal()),
    |r| plane(Point3::new(r, 0.0, r), Vector3::new(0.0, 1.0, 0.0).as_normal()),
    |r| cuboid([-r, -r, -r], [r, 0.1, r]),
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
