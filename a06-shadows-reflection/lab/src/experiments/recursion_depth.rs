//! The recursion between two mirrors that face each other.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_lab::support::Numbers;
use common::Error;
use measure::Effort;
use measure::experiment::{
    Axis, Curve, Curves, Errors, Experiment, HALF_GREY_LEVEL, Point, Slope, Times,
};

use crate::mirrors::Mirrors;
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld};

/// Between two mirrors that each emit 1 and have the reflectance k, the error of D
/// surfaces against the sum 1 / (1 - k) is `k^D / (1 - k)`. This falls by the same
/// factor with each surface, which is no straight line in a log-log plot. So the
/// parameter is the allowed error, and the depth follows.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How deep must the recursion go between two mirrors?",
        curves_are: Curves::Problems,
        parameter: "asked for (white = 1)",
        work: "rays",
        against: Axis::Parameter,
        error: "rms error of a colour",
        exact: "against the sum 1 / (1 - k) of all reflections",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("recursion-depth")
    }
}

const SEED: u64 = 4;

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let count = effort.choose(16, 256);
    let curve = |name, k| Curve {
        slope: Some(Slope {
            value: 1.0,
            between: 1e-10..=1e-1,
        }),
        ..Curve::new(name, points(k, count).unwrap_or_default())
    };
    vec![
        curve("k = 0.5", 0.5),
        curve("k = 0.8", 0.8),
        curve("k = 0.9", 0.9),
        curve("k = 0.95", 0.95),
        curve("k = 0.99", 0.99),
    ]
}

/// The errors of this number of rays for each allowed error.
fn points(k: f64, count: usize) -> Result<Vec<Point<'static>>, Error> {
    let mut points = Vec::new();
    for asked in [1e-1, 1e-2, HALF_GREY_LEVEL, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
        let mirrors = Mirrors {
            reflectance: k,
            ..Mirrors::default()
        };
        let run = Run {
            world: mirrors.world()?,
            rays: rays(count)?,
            depth: depth(k, asked),
        };
        let errors = run.traced().map(|light| light - 1.0 / (1.0 - k));
        points.push(Point {
            parameter: asked,
            work: count as f64 * f64::from(run.depth),
            errors: Errors::of(errors),
            times: Times::of(move || run.traced().sum::<f64>()),
        });
    }
    Ok(points)
}

/// Rays between mirrors.
struct Run {
    world: ShadowedWorld,
    rays: Vec<Ray>,
    depth: u32,
}

impl Run {
    /// The light that each ray brings back.
    fn traced(&self) -> impl Iterator<Item = f64> {
        let tracer = RecursiveTracer::new(&self.world);
        let rays = self.rays.iter();
        rays.map(move |ray| tracer.trace(ray, self.depth).r)
    }
}

/// The least depth D with `k^D / (1 - k)` not above the allowed error.
fn depth(k: f64, asked: f64) -> u32 {
    (libm::log(asked * (1.0 - k)) / libm::log(k)).ceil() as u32
}

/// Rays that start between the mirrors and go upwards, each at a slope of its own.
fn rays(count: usize) -> Result<Vec<Ray>, Error> {
    let mut rays = Vec::new();
    for n in 0..count {
        let mut numbers = Numbers::new(SEED, n);
        let mut aside = || numbers.between(-1.0, 1.0);
        let direction = Vector3::new(aside(), 1.0, aside());
        rays.push(Ray::new(Point3::ORIGIN, direction)?);
    }
    Ok(rays)
}
