//! Error against run time for mirrors and shadows.

pub mod secondary_rays;
mod shadow_terminator;

use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_lab::support::Numbers;
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL};

use crate::extremes::mirrors;
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld};

pub fn experiments() -> Vec<Experiment<'static>> {
    let mut all = vec![recursion_depth()];
    all.extend(secondary_rays::experiments());
    all.push(shadow_terminator::shadow_terminator());
    all
}

/// Between two mirrors that each emit 1 and have the reflectance k, the error of D
/// surfaces against the sum 1 / (1 - k) is `k^D / (1 - k)`. This falls by the same
/// factor with each surface, which is no straight line in a log-log plot. So the
/// parameter is the allowed error, and the depth follows.
fn recursion_depth() -> Experiment<'static> {
    Experiment::new("recursion-depth")
        .asking("How deep must the recursion go between two mirrors?")
        .of_problems()
        .over(Axis::Parameter, "asked for (white = 1)", "rays")
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
                    point.work *= f64::from(depth(k, point.parameter));
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
