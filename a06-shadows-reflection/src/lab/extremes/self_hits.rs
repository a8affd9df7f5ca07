//! Rays that leave the shape that they have hit, in scenes of every size: no ray
//! may hit it again, and no ray may miss an object close to it.

use std::rc::Rc;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::{Numbers, Triple, point};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use common::{Color, Error, argument};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id};

use crate::secondary_ray;

/// The world of a shape in a scene of this size.
pub type Shape = fn(f64) -> Result<World<()>, Error>;

/// A shape with its name, and the ids of its rows.
pub type Named<const SIZES: usize> = (&'static str, [Id; SIZES], Shape);

/// The shapes of this stage.
#[rustfmt::skip]
pub const SHAPES: [Named<5>; 4] = [
    ("a sphere", ["S13", "S33", "S34", "S35", "S36"],
        |size| world(Sphere::new(at(size, [0.1, 0.2, 0.3]), 0.7 * size)?)),
    ("a plane", ["S37", "S38", "S39", "S40", "S41"],
        |size| world(Plane::new(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.3, 1.0, 0.2))?)),
    ("a box", ["S42", "S43", "S44", "S45", "S46"],
        |size| world(AxisAlignedBox::new(at(size, [-0.3, -0.5, -0.1]), at(size, [0.6, 0.7, 0.8]))?)),
    ("a triangle", ["S47", "S48", "S49", "S50", "S51"], |size| {
        let corners = [[-0.9, -0.3, -0.5], [1.2, 0.1, -0.6], [0.3, 0.4, 1.3]];
        let [a, b, c] = corners.map(|corner| at(size, corner));
        world(Triangle::new(a, b, c)?)
    }),
];

pub fn world(shape: impl Geometry) -> Result<World<()>, Error> {
    Ok(World::new(Color::BLACK)?.with(shape, ()))
}

fn at(size: f64, place: Triple) -> Point3 {
    point(place.map(|x| x * size))
}

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(&SHAPES, [1e-6, 1e-3, 1.0, 1e4, 1e9], AIM, effort)
}

/// The number of wrong decisions at lit points of each shape in a scene of each size, with an
/// object before the light at a ten thousandth of the size.
pub fn rows<const SIZES: usize>(
    shapes: &[Named<SIZES>],
    sizes: [f64; SIZES],
    aim: Aim,
    effort: Effort,
) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let row = |name: &str, shape, id, size: f64| {
        let trials = trials(shape, size, count, aim);
        let wrong = |policy: Policy| {
            let is_wrong = |trial: &&Trial| trial.is_wrong(policy, 1e-4);
            let trials = trials.as_ref();
            trials.map(|trials| trials.iter().filter(is_wrong).count())
        };
        let what =
            format!("{name} of size {size:e}, {count} lit points: dark, or lit through an object");
        let case = Case::new(id, what, 0.0, Equal, wrong(LIFTED));
        match size {
            ..=1.0 => case.protocol(Fails, wrong(THOUSANDTH)),
            ..=1e4 => case.protocol(Holds, wrong(THOUSANDTH)),
            // Here the result depends on the rounding of single points.
            _ => case,
        }
    };
    let rows = shapes.iter().flat_map(|(name, ids, shape)| {
        let sizes = ids.iter().zip(sizes);
        sizes.map(|(id, size)| row(name, *shape, id, size))
    });
    rows.collect()
}

/// A rule for rays that leave a hit in a direction: the ray and its interval.
pub type Policy = fn(&Ray, &Hit, Vector3) -> (Ray, Interval);

/// Our policy: the offset of the origin.
pub const LIFTED: Policy = |ray, hit, light| (secondary_ray(ray, hit, light), Interval::AHEAD);

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub const THOUSANDTH: Policy = |ray, hit, light| from_point(ray, hit, light, 0.001);

/// The ray from the computed point, and this least `t`.
pub fn from_point(ray: &Ray, hit: &Hit, light: Vector3, min: f64) -> (Ray, Interval) {
    let max = f64::INFINITY;
    (Ray::derived(ray.at(hit.t), light), Interval { min, max })
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
    /// Whether the shape, which is convex, shadows itself.
    pub fn shades_itself(&self, policy: Policy) -> bool {
        let (to_light, within) = policy(&self.ray, &self.hit, self.light);
        self.world.is_hit(&to_light, within)
    }

    /// Whether a policy is wrong: the shape shadows itself, or the object at the
    /// distance `near` before the light is missed.
    pub fn is_wrong(&self, policy: Policy, near: f64) -> bool {
        let (to_light, within) = policy(&self.ray, &self.hit, self.light);
        let before = self.ray.at(self.hit.t) + self.light * (near * self.size);
        let occluder = Plane::new(before, self.light.as_normal());
        let is_found = occluder.is_ok_and(|plane| plane.hit(&to_light, within).is_some());
        self.shades_itself(policy) || !is_found
    }
}

/// A seed; and the eyes of trials: a middle, their distance from it, and the greatest distance
/// from it to a place where they look, in sizes of the scene.
pub type Aim = (u64, Triple, [f64; 2]);

pub const AIM: Aim = (13, [0.1, 0.2, 0.3], [5.0, 0.7]);

/// Rays for each point at most: a wrong formula may hit nothing.
const MOST_RAYS: usize = 1_000;

/// Lit points of a shape in a scene of a size.
pub fn trials(
    shape: Shape,
    size: f64,
    count: usize,
    (seed, middle, [distance, within]): Aim,
) -> Result<Vec<Trial>, Error> {
    let (world, middle) = (Rc::new(shape(size)?), at(size, middle));
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
            world: Rc::clone(&world),
            ray,
            hit,
            light: light * 1.0_f64.copysign(cosine),
            size,
        }))
    };
    let trials = (0..MOST_RAYS * count).filter_map(|n| trial(n).transpose());
    let trials = trials.take(count).collect::<Result<Vec<_>, Error>>()?;
    let (found, are_all) = (trials.len() as f64, trials.len() == count);
    argument::check("lit points", found, are_all, "as many as asked for")?;
    Ok(trials)
}
