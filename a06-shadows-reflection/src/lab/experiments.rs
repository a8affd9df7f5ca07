//! Error against run time for mirrors and shadows.

use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::{Hit, Interval};
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Unit};

use crate::lab::extremes::mirrors;
use crate::lab::extremes::self_hits::{
    AIM, LIFTED, Policy, SHAPES, THOUSANDTH, Trial, from_point, trials,
};
use crate::{RecursiveTracer, ShadowedWorld};

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![recursion_depth(), shadow_epsilon()]
}

/// Between two mirrors that each emit 1 and have the reflectance k, the error of D
/// surfaces against the sum 1 / (1 - k) is `k^D / (1 - k)`. This falls by the same
/// factor with each surface, which is no straight line in a log-log plot. So the
/// parameter is the allowed error, and the depth follows.
fn recursion_depth() -> Experiment<'static> {
    Experiment::new("recursion-depth")
        .asking("How deep must the recursion go between two mirrors?")
        .over(Axis::Knob, "asked for (white = 1)", "rays")
        .with_error("rms error of a colour")
        .with_exact("against the sum 1 / (1 - k) of all reflections")
        .with_seeds(&[4])
        .with_curves(|effort| {
            let asked = [1e-1, 1e-2, HALF_GREY_LEVEL, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10];
            let rays: Vec<_> = (0..effort.choose(16, 256)).filter_map(ray).collect();
            let curve = |method, k: f64| {
                let world = mirrors((1.0, k, 0.0)).map(Rc::new).ok();
                let sets = asked.map(|asked| {
                    let task =
                        |ray: &Ray| Some((Rc::clone(world.as_ref()?), *ray, depth(k, asked)));
                    (asked, rays.iter().filter_map(task).collect())
                });
                let trace = |(world, ray, depth): &(Rc<ShadowedWorld>, Ray, u32)| {
                    RecursiveTracer::new(world).trace(ray, *depth).r
                };
                let error = |_: &_, light| [light - 1.0 / (1.0 - k)];
                let mut curve = Curve::of_tasks(method, &sets, trace, error);
                for point in &mut curve.points {
                    point.work *= f64::from(depth(k, point.knob));
                }
                curve.with_slope(1.0, (1e-10, 1e-1))
            };
            vec![
                curve("k = 0.5", 0.5),
                curve("k = 0.8", 0.8),
                curve("k = 0.9", 0.9),
                curve("k = 0.95", 0.95),
                curve("k = 0.99", 0.99),
            ]
        })
}

/// The least depth D with `k^D / (1 - k)` not above the allowed error.
fn depth(k: f64, asked: f64) -> u32 {
    (libm::log(asked * (1.0 - k)) / libm::log(k)).ceil() as u32
}

/// A ray that starts between the mirrors and goes upwards, at a slope of its own.
fn ray(n: usize) -> Option<Ray> {
    let mut numbers = Numbers::new(4, n);
    let mut aside = || numbers.between(-1.0, 1.0);
    Ray::new(Point3::ORIGIN, Vector3::new(aside(), 1.0, aside())).ok()
}

/// Distances of an object before the light, in sizes of the scene, for one half of
/// the rays each.
const NEAR: [f64; 2] = [1e-4, 1e-10];

/// A bound in proportion to the largest number of the hit.
fn relative(ray: &Ray, hit: &Hit, light: Vector3) -> (Ray, Interval) {
    let points = [ray.origin(), ray.at(hit.t)];
    let [eye, point] = points.map(Point3::largest_coordinate);
    from_point(ray, hit, light, 1e-9 * eye.max(point).max(hit.t))
}

fn shadow_epsilon() -> Experiment<'static> {
    Experiment::new("shadow-epsilon")
        .asking("What keeps a surface out of its own shadow, and lets nothing else through?")
        .over(Axis::Knob, "scene size (units)", "shadow rays")
        .with_error("share of wrong shadow rays")
        .with_unit(Unit::Share)
        .with_exact("of the surface itself, or through an object")
        .with_seeds(&[13])
        .with_curves(|effort| {
            let count = effort.choose(1_024, 16_384);
            let scenes = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9].map(|size| {
                let all = SHAPES.map(|(.., shape)| trials(shape, size, count, AIM));
                (size, all.into_iter().flatten().flatten().collect())
            });
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
                    from_point(ray, hit, light, 0.0)
                })
                .with_remark("whether a surface shades itself is luck of rounding"),
                curve("above 1e-6", |ray, hit, light| {
                    from_point(ray, hit, light, 1e-6)
                })
                .with_remark("the same walls elsewhere"),
                curve("above 1e-9 of the largest", relative)
                    .with_remark("the same at every size, but blind to what is nearer"),
                curve("lifted along the normal", LIFTED)
                    .with_bound(0.0, 0.0..=f64::INFINITY)
                    .with_remark("ours; never wrong, which a logarithm cannot show"),
            ]
        })
}
