//! Rays that leave the shape that they have hit, in scenes of every size: no ray
//! may hit it again, and no ray may miss an object close to it.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use a04_lab::support::{Numbers, Triple};
use common::{Error, argument};

use crate::policy::Policy;
use crate::surface::{Shape, Surface, at};

/// A point that a light shines on.
pub struct Trial {
    pub surface: Surface,
    pub ray: Ray,
    pub hit: Hit,
    pub light: Vector3,
    size: f64,
}

impl Trial {
    /// The computed point.
    pub fn point(&self) -> Point3 {
        self.ray.at(self.hit.t)
    }

    /// The geometric normal on the side of the light.
    pub fn normal_to_the_light(&self) -> Vector3 {
        let normal = Vector3::from(self.hit.geometric_normal);
        normal * 1.0_f64.copysign(self.light.dot(normal))
    }

    /// The ray from the computed point, and this least `t`.
    pub fn from_point(&self, min: f64) -> (Ray, Interval) {
        let max = f64::INFINITY;
        (
            Ray::derived(self.point(), self.light),
            Interval { min, max },
        )
    }

    /// Whether the shape, which is convex, shadows itself.
    pub fn shades_itself(&self, policy: Policy) -> bool {
        let (to_light, within) = policy(self);
        self.surface.world.is_hit(&to_light, within)
    }

    /// Whether an object at the distance `near` before the light, in sizes, is missed.
    pub fn leaks(&self, policy: Policy, near: f64) -> bool {
        let (to_light, within) = policy(self);
        let before = self.point() + self.light * (near * self.size);
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

/// A shape, an eye and a place where it looks, from random numbers.
pub type Look = (Surface, [Point3; 2]);

/// Looks at a shape of a size in a scene of a size.
pub fn looks(
    shape: Shape,
    shape_size: f64,
    size: f64,
    (middle, [distance, within]): Aim,
) -> Result<impl Fn(&mut Numbers) -> Result<Look, Error>, Error> {
    let (surface, middle) = (shape(shape_size)?, at(size, middle));
    Ok(move |numbers: &mut Numbers| {
        let mut way = || numbers.triple(-1.0, 1.0);
        let eye = middle + way().unit("eye")? * (distance * size);
        Ok((surface.clone(), [eye, middle + way() * (within * size)]))
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
        let (surface, [eye, target]) = look(&mut numbers)?;
        let ray = Ray::new(eye, target - eye)?;
        let Some((hit, ())) = surface.world.hit(&ray, Interval::AHEAD) else {
            return Ok(None);
        };
        let light = numbers.triple(-1.0, 1.0).unit("light")?;
        let cosine = light.dot(hit.geometric_normal);
        // At grazing angles either result is right.
        Ok((cosine.abs() >= 1e-3).then(|| Trial {
            surface,
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
