//! Rays that leave the shape that they have hit, in scenes of every size: no ray
//! may hit it again, and no ray may miss an object close to it.

use std::rc::Rc;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a04_lab::support::{Numbers, Triple, point};
use common::{Color, Error, argument};

use a06_shadows_reflection::secondary_ray;

/// The world of a shape in a scene of this size.
pub type Shape = fn(f64) -> Result<World<()>, Error>;

/// The shapes of this stage.
pub const SHAPES: [Shape; 4] = [
    |size| world(Sphere::new(at(size, [0.1, 0.2, 0.3]), 0.7 * size)?),
    |size| {
        world(Plane::new(
            at(size, [0.1, 0.2, 0.3]),
            Normal3::new(0.3, 1.0, 0.2),
        )?)
    },
    |size| {
        world(AxisAlignedBox::new(
            at(size, [-0.3, -0.5, -0.1]),
            at(size, [0.6, 0.7, 0.8]),
        )?)
    },
    |size| {
        let corners = [[-0.9, -0.3, -0.5], [1.2, 0.1, -0.6], [0.3, 0.4, 1.3]];
        let [a, b, c] = corners.map(|corner| at(size, corner));
        world(Triangle::new(a, b, c)?)
    },
];

pub fn world(shape: impl Geometry) -> Result<World<()>, Error> {
    Ok(World::new(Color::BLACK)?.with(shape, ()))
}

fn at(size: f64, place: Triple) -> Point3 {
    point(place.map(|x| x * size))
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

    /// Whether an object at the distance `near` before the light, in sizes, is missed.
    pub fn leaks(&self, policy: Policy, near: f64) -> bool {
        let (to_light, within) = policy(&self.ray, &self.hit, self.light);
        let before = self.ray.at(self.hit.t) + self.light * (near * self.size);
        let occluder = Plane::new(before, self.light.as_normal());
        !occluder.is_ok_and(|plane| plane.hit(&to_light, within).is_some())
    }
}

/// The eyes of trials: a middle, their distance from it, and the greatest distance from it to a
/// place where they look, in sizes of the scene.
pub type Aim = (Triple, [f64; 2]);

pub const SEED: u64 = 13;
pub const AIM: Aim = ([0.1, 0.2, 0.3], [5.0, 0.7]);

/// Rays for each point at most: a wrong formula may hit nothing.
const MOST_RAYS: usize = 1_000;

/// A world, an eye and a place where it looks, from random numbers.
pub type Look = (Rc<World<()>>, [Point3; 2]);

/// Looks at a shape of a size in a scene of a size.
pub fn looks(
    shape: Shape,
    shape_size: f64,
    size: f64,
    (middle, [distance, within]): Aim,
) -> Result<impl Fn(&mut Numbers) -> Result<Look, Error>, Error> {
    let (world, middle) = (Rc::new(shape(shape_size)?), at(size, middle));
    Ok(move |numbers: &mut Numbers| {
        let mut way = || numbers.triple(-1.0, 1.0);
        let eye = middle + way().unit("eye")? * (distance * size);
        Ok((Rc::clone(&world), [eye, middle + way() * (within * size)]))
    })
}

/// Lit points in scenes of a size.
pub fn trials(
    count: usize,
    seed: u64,
    size: f64,
    look: impl Fn(&mut Numbers) -> Result<Look, Error>,
) -> Result<Vec<Trial>, Error> {
    let trial = |n| {
        let mut numbers = Numbers::new(seed, n);
        let (world, [eye, target]) = look(&mut numbers)?;
        let ray = Ray::new(eye, target - eye)?;
        let Some((hit, ())) = world.hit(&ray, Interval::AHEAD) else {
            return Ok(None);
        };
        let light = numbers.triple(-1.0, 1.0).unit("light")?;
        let cosine = light.dot(hit.face);
        // At grazing angles either result is right.
        Ok((cosine.abs() >= 1e-3).then(|| Trial {
            world,
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
