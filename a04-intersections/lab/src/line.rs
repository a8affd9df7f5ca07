//! `Line`: origin and direction of a ray as plain numbers, the arguments of formulas.

use a02_math::arrays::{array, point, vector};
use a03_rays_cameras::Ray;
use common::ArgumentError;

use crate::number::{Number, Triple};

/// The points `origin + t direction`.
#[derive(Clone, Copy, Debug)]
pub struct Line<N = f64> {
    pub origin: Triple<N>,
    pub direction: Triple<N>,
}

/// The line from an origin in a direction of any length.
pub const fn line(origin: Triple, direction: Triple) -> Line {
    Line { origin, direction }
}

impl Line {
    /// The line of a ray.
    pub fn of(ray: &Ray) -> Self {
        line(array(ray.origin()), array(ray.direction()))
    }

    /// The ray as in a scene, with a direction of length 1.
    pub fn unit_ray(self) -> Result<Ray, ArgumentError> {
        Ray::new(point(self.origin), vector(self.direction))
    }

    /// The ray as in the protocol: unchecked.
    pub const fn raw_ray(self) -> Ray {
        Ray::derived(point(self.origin), vector(self.direction))
    }

    /// The ray as in a scene, or unchecked if `Ray::new` refuses it.
    pub fn any_ray(self) -> Ray {
        self.unit_ray().unwrap_or(self.raw_ray())
    }

    /// The line in numbers of another type.
    pub fn to<N: Number>(&self) -> Line<N> {
        Line {
            origin: self.origin.map(N::of),
            direction: self.direction.map(N::of),
        }
    }
}
