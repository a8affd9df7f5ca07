//! Methods against self-shadowing, at every size of a scene.

use std::rc::Rc;

use a02_math::Vector3;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use crate::lab::extremes::self_hits::{
    LIFTED, Policy, SHAPES, THOUSANDTH, Trial, from_point, trials,
};

const SIZES: [f64; 8] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9];

/// Distances of an object before the light, in sizes of the scene, for one half of
/// the rays each.
const NEAR: [f64; 2] = [1e-4, 1e-10];

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
            let curve = |method, policy: Policy| {
                let is_dark = move |trial: &Trial| trial.shades_itself(policy);
                let wrong = |trial: &Trial, _| {
                    let wrong = NEAR.map(|near| f64::from(trial.is_wrong(policy, near)));
                    wrong.iter().sum::<f64>() / NEAR.len() as f64
                };
                Curve::of_decisions(method, &scenes, is_dark, wrong)
            };
            vec![
                curve("above 1e-3 (protocol)", THOUSANDTH)
                    .with_remark("a length, and too much for all but the largest scene"),
                curve("above 0", |ray, hit, light| {
                    (from_point(ray, hit, light), 0.0)
                })
                .with_remark("whether a surface shades itself is luck of rounding"),
                curve("above 1e-6", |ray, hit, light| {
                    (from_point(ray, hit, light), 1e-6)
                })
                .with_remark("the same walls elsewhere"),
                curve("above 1e-9 of the largest", relative)
                    .with_remark("the same at every size, but blind to what is nearer"),
                curve("lifted along the normal", LIFTED)
                    .with_bound(0.0, 0.0..=f64::INFINITY)
                    .with_remark("ours; never wrong, which a logarithm cannot show"),
            ]
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
