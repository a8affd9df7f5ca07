//! The recursion depth needed for a given error.
//!
//! Between two mirrors that each emit 1 and have the reflectance k, the error of D
//! surfaces against the sum 1 / (1 - k) is `k^D / (1 - k)`. This falls by the same
//! factor with each surface, which is no straight line in a log-log plot. So the
//! parameter is the allowed error, and the depth follows.

use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point, Unit};

use crate::lab::extremes::mirrors::mirrors;
use crate::{RecursiveTracer, ShadowedWorld};

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "recursion-depth",
        about: "How deep must the recursion go between two mirrors?",
        knob: "asked for (white = 1)",
        work: "rays",
        error: "rms error of a colour",
        unit: Unit::Light,
        exact: "against the sum 1 / (1 - k) of all reflections",
        seeds: &[4],
        against: Axis::Knob,
        curves: Box::new(|effort| {
            let rays = rays(effort.choose(16, 256));
            let asked = [1e-1, 1e-2, HALF_GREY_LEVEL, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10];
            let point = |k: f64, world: &Rc<ShadowedWorld>, asked: f64| {
                let depth = depth(k, asked);
                let (world, rays) = (Rc::clone(world), Rc::clone(&rays));
                let trace = move |ray: &Ray| RecursiveTracer::new(&world).trace(ray, depth).r;
                let error = |ray: &Ray| trace(ray) - 1.0 / (1.0 - k);
                let errors: Vec<_> = rays.iter().map(error).collect();
                let work = f64::from(depth) * rays.len() as f64;
                Point::new(asked, work, errors, move || {
                    rays.iter().map(&trace).sum::<f64>()
                })
            };
            let curve = |method, k| {
                let world = mirrors(k).world().map(Rc::new).into_iter();
                let points = world.flat_map(|world| asked.map(|asked| point(k, &world, asked)));
                Curve::new(method, points).with_slope(1.0, (1e-10, 1e-1))
            };
            vec![
                curve("k = 0.5", 0.5),
                curve("k = 0.8", 0.8),
                curve("k = 0.9", 0.9),
                curve("k = 0.95", 0.95),
                curve("k = 0.99", 0.99),
            ]
        }),
    }
}

/// The least depth D with `k^D / (1 - k)` not above the allowed error.
fn depth(k: f64, asked: f64) -> u32 {
    (libm::log(asked * (1.0 - k)) / libm::log(k)).ceil() as u32
}

/// Rays that start between the mirrors and go upwards, at various slopes.
fn rays(count: usize) -> Rc<[Ray]> {
    let ray = |n: usize| {
        let mut numbers = Numbers::new(4, n);
        let mut aside = || numbers.between(-1.0, 1.0);
        let up = Vector3::new(aside(), 1.0, aside());
        Ray::new(Point3::new(0.0, 0.5, 0.0), up).ok()
    };
    (0..count).filter_map(ray).collect()
}
