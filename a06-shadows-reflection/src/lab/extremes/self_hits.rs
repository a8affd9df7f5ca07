//! Rays that leave the shape that they have hit, in scenes of every size: no ray
//! may hit it again, and no ray may miss an object close to it.

use std::rc::Rc;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use common::{Color, Error, argument};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id};

use crate::secondary_ray;

/// Lit points of a shape in a scene of a size.
pub type Trials = Result<Vec<Trial>, Error>;

/// The world of a shape of this size.
type Shape = fn(f64) -> Result<World<()>, Error>;

/// The shapes of this stage, with the ids of their rows.
pub const SHAPES: [(&str, [&str; 5], Shape); 4] = [
    ("a sphere", ["S13", "S33", "S34", "S35", "S36"], |size| {
        world(Sphere::new(at(size, 0.1, 0.2, 0.3), 0.7 * size)?)
    }),
    ("a plane", ["S37", "S38", "S39", "S40", "S41"], |size| {
        let normal = Normal3::new(0.3, 1.0, 0.2);
        world(Plane::new(at(size, 0.1, 0.2, 0.3), normal)?)
    }),
    ("a box", ["S42", "S43", "S44", "S45", "S46"], |size| {
        let (lbf, run) = (at(size, -0.3, -0.5, -0.1), at(size, 0.6, 0.7, 0.8));
        world(AxisAlignedBox::new(lbf, run)?)
    }),
    ("a triangle", ["S47", "S48", "S49", "S50", "S51"], |size| {
        let (a, b) = (at(size, -0.9, -0.3, -0.5), at(size, 1.2, 0.1, -0.6));
        world(Triangle::new(a, b, at(size, 0.3, 0.4, 1.3))?)
    }),
];

pub fn world(shape: impl Geometry + 'static) -> Result<World<()>, Error> {
    Ok(World::new(Color::BLACK)?.with(shape, ()))
}

fn at(size: f64, x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x * size, y * size, z * size)
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let mut cases = Vec::new();
    for (name, ids, shape) in SHAPES {
        for (id, size) in ids.into_iter().zip([1e-6, 1e-3, 1.0, 1e4, 1e9]) {
            let what = format!("{name} of size {size:e}, {count} lit points");
            cases.push(row(id, &what, size, &trials(shape, size, count)));
        }
    }
    cases
}

/// The number of wrong decisions at the lit points of a shape, with an object before the
/// light at a ten thousandth of the scene's size.
pub fn row(id: Id, what: &str, size: f64, trials: &Trials) -> Case {
    let wrong = |policy: Policy| {
        let is_wrong = |trial: &&Trial| trial.is_wrong(policy, 1e-4);
        let trials = trials.as_ref();
        trials.map(|trials| trials.iter().filter(is_wrong).count())
    };
    let what = format!("{what}: dark, or lit through an object");
    let case = Case::new(id, what, 0.0, Equal, wrong(LIFTED));
    match size {
        ..=1.0 => case.protocol(Fails, wrong(THOUSANDTH)),
        ..=1e4 => case.protocol(Holds, wrong(THOUSANDTH)),
        // Here the result depends on the rounding of single points.
        _ => case,
    }
}

/// A rule for rays that leave a hit: the ray and its least `t`.
pub type Policy = fn(&Ray, &Hit, Vector3) -> (Ray, f64);

/// Our policy: the offset of the origin.
pub const LIFTED: Policy = |ray, hit, light| (secondary_ray(ray, hit, light), 0.0);

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub const THOUSANDTH: Policy = |ray, hit, light| (from_point(ray, hit, light), 0.001);

/// The ray from the computed point.
pub fn from_point(ray: &Ray, hit: &Hit, light: Vector3) -> Ray {
    Ray::derived(ray.at(hit.t), light)
}

/// A point that a light shines on.
pub struct Trial {
    world: Rc<World<()>>,
    ray: Ray,
    hit: Hit,
    light: Vector3,
    size: f64,
}

impl Trial {
    /// The ray to the light, and its interval.
    fn to_light(&self, policy: Policy) -> (Ray, Interval) {
        let (ray, min) = policy(&self.ray, &self.hit, self.light);
        let max = f64::INFINITY;
        (ray, Interval { min, max })
    }

    /// Whether the shape, which is convex, shadows itself.
    pub fn shades_itself(&self, policy: Policy) -> bool {
        let (to_light, within) = self.to_light(policy);
        self.world.is_hit(&to_light, within)
    }

    /// Whether a policy is wrong: the shape shadows itself, or the object at the
    /// distance `near` before the light is missed.
    pub fn is_wrong(&self, policy: Policy, near: f64) -> bool {
        let (to_light, within) = self.to_light(policy);
        let before = self.ray.at(self.hit.t) + self.light * (near * self.size);
        let occluder = Plane::new(before, self.light.as_normal());
        let is_found = occluder.is_ok_and(|plane| plane.hit(&to_light, within).is_some());
        self.shades_itself(policy) || !is_found
    }
}

/// Lit points of a shape, seen from 5 sizes away.
pub fn trials(shape: Shape, size: f64, count: usize) -> Trials {
    let world = Rc::new(shape(size)?);
    let middle = at(size, 0.1, 0.2, 0.3);
    seen(&world, 13, middle, size, [5.0, 0.7], count)
}

/// Rays for each point at most: a wrong formula may hit nothing.
const MOST_RAYS: usize = 1_000;

/// Lit points of a world, seen from one distance from the middle towards places within
/// the other.
pub fn seen(
    world: &Rc<World<()>>,
    seed: u64,
    middle: Point3,
    size: f64,
    [distance, within]: [f64; 2],
    count: usize,
) -> Trials {
    let trial = |n| {
        let mut numbers = Numbers::new(seed, n);
        let mut way = || numbers.triple(-1.0, 1.0);
        let eye = middle + way().unit("eye")? * (distance * size);
        let target = middle + way() * (within * size);
        let ray = Ray::new(eye, target - eye)?;
        let Some((hit, ())) = world.hit(&ray, Interval::AHEAD) else {
            return Ok(None);
        };
        let light = way().unit("light")?;
        let cosine = light.dot(hit.face);
        // At grazing angles either result is right.
        Ok((cosine.abs() >= 1e-3).then(|| Trial {
            world: Rc::clone(world),
            ray,
            hit,
            light: light * 1.0_f64.copysign(cosine),
            size,
        }))
    };
    let trials = (0..MOST_RAYS * count).filter_map(|n| trial(n).transpose());
    let trials = trials.take(count).collect::<Result<Vec<_>, Error>>()?;
    let hits = trials.len() as f64;
    argument::check(
        "lit points",
        hits,
        trials.len() == count,
        "as many as asked for",
    )?;
    Ok(trials)
}
