//! Wrong decisions of rays that leave a surface: acne, where it shades itself, and leaks, where
//! a ray passes through an object near it.

use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Hit, Interval, Plane, Sphere, Triangle};
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use crate::lit_points::{
    AIM, Aim, LIFTED, Policy, SEED, SHAPES, Shape, THOUSANDTH, Trial, from_point, looks, trials,
    world,
};

pub fn experiments() -> Vec<Experiment<'static>> {
    let size = "scene size (units)";
    let ratio = "size of the shape (sizes of the view)";
    vec![
        acne("acne", "Which rays keep a surface out of its own shadow?").over(size, by_size),
        leaks("leaks", "Which rays find an object near the surface?").over(size, by_size),
        acne("acne-of-large-shapes", "How large may a shape be?").over(ratio, by_ratio),
    ]
}

/// Values of the parameter, each with lit points.
pub type Sets = Vec<(f64, Rc<[Trial]>)>;

/// A kind of wrong decision, which gives the share of wrong ones for a point and a policy.
pub struct Wrong(Experiment<'static>, fn(&Trial, Policy) -> f64);

/// The shape is convex and the light outside, but a ray to it hits the shape.
pub fn acne(name: &'static str, question: &'static str) -> Wrong {
    let wrong = |trial: &Trial, policy: Policy| f64::from(trial.shades_itself(policy));
    let experiment = Experiment::new(name).asking(question);
    let experiment = experiment.with_error("share of shadow rays that hit their own surface");
    Wrong(experiment.with_exact("where light arrives"), wrong)
}

/// A ray to the light misses an object at one of the distances `NEAR`.
pub fn leaks(name: &'static str, question: &'static str) -> Wrong {
    let wrong = |trial: &Trial, policy: Policy| {
        let leaks = NEAR.map(|near| f64::from(trial.leaks(policy, near)));
        leaks.iter().sum::<f64>() / NEAR.len() as f64
    };
    let experiment = Experiment::new(name).asking(question);
    let experiment = experiment.with_error("share of shadow rays that miss an object");
    Wrong(experiment.with_exact("1e-4 or 1e-9 sizes away"), wrong)
}

/// Distances of an object before the light, in sizes of the scene.
const NEAR: [f64; 2] = [1e-4, 1e-9];

/// A name and the rule for rays that leave a hit.
const POLICIES: [(&str, Policy); 5] = [
    ("above 1e-3 (protocol)", THOUSANDTH),
    ("above 0", |ray, hit, light| {
        from_point(ray, hit, light, 0.0)
    }),
    ("above 1e-6", |ray, hit, light| {
        from_point(ray, hit, light, 1e-6)
    }),
    ("above 1e-9 of the largest", relative),
    ("lifted (ours)", LIFTED),
];

/// A bound in proportion to the largest number of the hit.
fn relative(ray: &Ray, hit: &Hit, light: Vector3) -> (Ray, Interval) {
    let points = [ray.origin(), ray.at(hit.t)];
    let [eye, point] = points.map(Point3::largest_coordinate);
    from_point(ray, hit, light, 1e-9 * eye.max(point).max(hit.t))
}

impl Wrong {
    /// The experiment over a parameter. Our rays are never wrong.
    pub fn over(self, knob: &'static str, sets: fn(Effort) -> Sets) -> Experiment<'static> {
        let Self(experiment, wrong) = self;
        let experiment = experiment.over(Axis::Knob, knob, "shadow rays");
        let experiment = experiment.with_unit(Unit::Share).with_seeds(&[SEED]);
        experiment.with_curves(move |effort| {
            let sets = sets(effort);
            let curve = |(method, policy): (_, Policy)| {
                let run = move |trial: &Trial| trial.shades_itself(policy);
                let wrong = move |trial: &Trial, _| wrong(trial, policy);
                Curve::of_decisions(method, &sets, run, wrong)
            };
            let [protocol, zero, millionth, relative, ours] = POLICIES.map(curve);
            let ours = ours.with_bound(0.0, 0.0..=f64::INFINITY);
            vec![protocol, zero, millionth, relative, ours]
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

/// Slanted surfaces through the origin, of shapes of any size.
#[rustfmt::skip]
const LARGE: [Shape; 4] = [
    |r| world(Sphere::new(Point3::ORIGIN - NORMAL * r, r)?),
    |r| world(Plane::new(Point3::ORIGIN + ALONG * r, NORMAL.as_normal())?),
    |r| world(AxisAlignedBox::new(Point3::new(-r, -r, -r), Point3::new(r, 0.1, r))?),
    |r| {
        let corners = [ALONG - ACROSS, ALONG + ACROSS, ALONG * -2.0];
        let [a, b, c] = corners.map(|v| Point3::ORIGIN + v * (20.0 * r));
        world(Triangle::new(a, b, c)?)
    },
];

/// Three directions at right angles.
const NORMAL: Vector3 = Vector3::new(2.0 / 7.0, 6.0 / 7.0, 3.0 / 7.0);
const ALONG: Vector3 = Vector3::new(6.0 / 7.0, -3.0 / 7.0, 2.0 / 7.0);
const ACROSS: Vector3 = Vector3::new(3.0 / 7.0, 2.0 / 7.0, -6.0 / 7.0);
