//! Methods against self-shadowing, at every size of a scene.

use std::rc::Rc;

use a02_math::Vector3;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit, share};

use crate::lab::extremes::self_hits::{
    LIFTED, Policy, SHAPES, THOUSANDTH, Trial, from_point, trials,
};

const SIZES: [f64; 8] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9];

/// Distances of an object before the light, in sizes of the scene, for one half of
/// the rays each.
const NEAR: [f64; 2] = [1e-4, 1e-10];

const POLICIES: [(&str, Policy, &str); 5] = [
    (
        "above 1e-3 (protocol)",
        THOUSANDTH,
        "a length, and too much for all but the largest scene",
    ),
    (
        "above 0",
        |ray, hit, light| (from_point(ray, hit, light), 0.0),
        "whether a surface shades itself is luck of rounding",
    ),
    (
        "above 1e-6",
        |ray, hit, light| (from_point(ray, hit, light), 1e-6),
        "the same walls elsewhere",
    ),
    (
        "above 1e-9 of the largest",
        relative,
        "the same at every size, but blind to what is nearer",
    ),
    (
        "lifted along the normal",
        LIFTED,
        "ours; never wrong, which a logarithm cannot show",
    ),
];

/// A bound in proportion to the largest number of the hit.
fn relative(ray: &Ray, hit: &Hit, light: Vector3) -> (Ray, f64) {
    let ray_to_light = from_point(ray, hit, light);
    let [eye, point] = [ray, &ray_to_light].map(|ray| ray.origin().largest_coordinate());
    (ray_to_light, 1e-9 * eye.max(point).max(hit.t))
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "shadow-epsilon",
        about: "What keeps a surface out of its own shadow, and lets nothing else through?",
        knob: "scene size (units)",
        work: "shadow rays",
        error: "share of wrong shadow rays",
        unit: Unit::Share,
        exact: "of the surface itself, or through an object",
        seeds: &[13],
        against: Axis::Knob,
        curves: Box::new(|effort| {
            let scenes = SIZES.map(|size| (size, scene(size, effort).unwrap_or_default()));
            let curve = |(method, policy, remark): (_, Policy, _)| {
                let wrong = |trials: &[Trial]| {
                    let shares = NEAR.map(|near| share(trials, |t| t.is_wrong(policy, near)));
                    vec![shares.concat().iter().sum::<f64>() / NEAR.len() as f64]
                };
                let run = move |trial: &Trial| f64::from(trial.shades_itself(policy));
                Curve::of_tasks(method, &scenes, wrong, run).with_remark(remark)
            };
            POLICIES.map(curve).into()
        }),
    }
}

/// Trials of one size, of all shapes.
fn scene(size: f64, effort: Effort) -> Result<Rc<[Trial]>, Error> {
    let count = effort.choose(1_024, 16_384);
    let all = SHAPES.map(|(.., shape)| trials(shape, size, count));
    let all = all.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(all.into_iter().flatten().collect())
}
