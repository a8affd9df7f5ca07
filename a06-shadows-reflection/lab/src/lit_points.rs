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
pub struct LitPoint {
    pub surface: Surface,
    /// The ray that sees the point.
    pub ray: Ray,
    pub hit: Hit,
    /// The direction to the light, of length 1.
    pub light: Vector3,
    /// The size of the scene.
    size: f64,
}

impl LitPoint {
    /// The computed point.
    pub fn point(&self) -> Point3 {
        self.ray.at(self.hit.t)
    }

    /// Whether the shape, which is convex, shadows itself.
    pub fn shades_itself(&self, policy: Policy) -> bool {
        let to_light = policy(self);
        self.surface.is_hit(&to_light.ray, to_light.within)
    }

    /// Whether an object at the distance `near` before the light, in sizes, is missed.
    pub fn leaks(&self, policy: Policy, near: f64) -> bool {
        let to_light = policy(self);
        let before = self.point() + self.light * (near * self.size);
        let Ok(occluder) = Plane::new(before, self.light.as_normal()) else {
            return true;
        };
        occluder.hit(&to_light.ray, to_light.within).is_none()
    }
}

/// Where the eyes are, and where they look. Lengths are in sizes of the scene.
#[derive(Clone, Copy)]
pub struct Aim {
    pub middle: Triple,
    /// Of the eye from the middle.
    pub distance: f64,
    /// The reach around the middle in which the targets lie.
    pub within: f64,
}

pub const SEED: u64 = 13;

pub const AIM: Aim = Aim {
    middle: [0.1, 0.2, 0.3],
    distance: 5.0,
    within: 0.7,
};

/// Rays for each point at most: a wrong formula may hit nothing.
const MAX_RAYS: usize = 1_000;

/// A shape, and a ray from an eye to a target, from random numbers.
pub struct EyeRay {
    pub surface: Surface,
    pub eye: Point3,
    pub target: Point3,
}

/// Rays from the eye to a shape of a size in a scene of a size.
pub fn eye_rays(
    shape: Shape,
    shape_size: f64,
    size: f64,
    aim: Aim,
) -> Result<impl Fn(&mut Numbers) -> Result<EyeRay, Error>, Error> {
    let (surface, middle) = (shape(shape_size)?, at(size, aim.middle));
    Ok(move |numbers: &mut Numbers| {
        let direction = numbers.triple(-1.0, 1.0).unit("eye")?;
        let aside = numbers.triple(-1.0, 1.0);
        Ok(EyeRay {
            surface: surface.clone(),
            eye: middle + direction * (aim.distance * size),
            target: middle + aside * (aim.within * size),
        })
    })
}

/// Lit points in scenes of a size.
pub fn from_eye_rays(
    count: usize,
    seed: u64,
    size: f64,
    eye_ray: impl Fn(&mut Numbers) -> Result<EyeRay, Error>,
) -> Result<Vec<LitPoint>, Error> {
    let mut points = Vec::new();
    for n in 0..MAX_RAYS * count {
        if points.len() == count {
            break;
        }
        let mut numbers = Numbers::new(seed, n);
        let EyeRay {
            surface,
            eye,
            target,
        } = eye_ray(&mut numbers)?;
        let ray = Ray::new(eye, target - eye)?;
        let Some((hit, ())) = surface.hit(&ray, Interval::AHEAD) else {
            continue;
        };
        let light = numbers.triple(-1.0, 1.0).unit("light")?;
        let cosine = light.dot(hit.geometric_normal);
        // At grazing angles either result is right.
        if cosine.abs() < 1e-3 {
            continue;
        }
        points.push(LitPoint {
            surface,
            ray,
            hit,
            light: light * 1.0_f64.copysign(cosine),
            size,
        });
    }
    let are_all = points.len() == count;
    argument::check(
        "lit points",
        points.len() as f64,
        are_all,
        "as many as asked for",
    )?;
    Ok(points)
}
