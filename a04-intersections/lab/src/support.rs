//! Numbers of shapes, hits, and random numbers for experiments and extreme cases.

pub use a02_math::arrays::{point, vector};
use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};

pub use crate::number::Triple;
use a04_intersections::registry::{Content, ShapeKind};
use a04_intersections::{Geometry, Interval, Triangle};

/// The numbers of a shape under a key of its table in a scene file; NaN if it has not `N` numbers.
pub fn numbers<const N: usize>(shape: &impl ShapeKind, key: &str) -> [f64; N] {
    let Content::Values(values) = shape.content() else {
        return [f64::NAN; N];
    };
    for (name, numbers) in values {
        if name == key {
            return numbers.try_into().unwrap_or([f64::NAN; N]);
        }
    }
    [f64::NAN; N]
}

/// The corners of a triangle.
pub fn corners(triangle: &Triangle) -> [Point3; 3] {
    let [ax, ay, az, bx, by, bz, cx, cy, cz] = numbers(triangle, "corners");
    [[ax, ay, az], [bx, by, bz], [cx, cy, cz]].map(point)
}

/// The `t` of a ray's nearest hit of a shape.
pub fn first(shape: &(impl Geometry + ?Sized), ray: &Ray) -> Option<f64> {
    shape.hit(ray, Interval::AHEAD).map(|hit| hit.t)
}

/// Random numbers and directions that are the same in every run.
pub struct Numbers {
    random: PixelRandom,
    drawn: u64,
}

impl Numbers {
    /// The numbers of the `n`-th ray or other object.
    pub const fn new(seed: u64, n: usize) -> Self {
        Self {
            random: PixelRandom::new(seed, n as u32, 0),
            drawn: 0,
        }
    }

    /// The next number of an interval.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        self.drawn += 1;
        least + (most - least) * self.random.uniform(self.drawn - 1)
    }

    /// The next whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.between(0.0, count as f64) as usize
    }

    pub fn triple(&mut self, least: f64, most: f64) -> Vector3 {
        vector(std::array::from_fn(|_| self.between(least, most)))
    }

    pub fn direction(&mut self) -> Vector3 {
        loop {
            let inside = self.triple(-1.0, 1.0);
            if (0.01..=1.0).contains(&inside.magnitude()) {
                return inside * (1.0 / inside.magnitude());
            }
        }
    }

    /// Two vectors of length 1, perpendicular up to rounding.
    pub fn perpendicular(&mut self) -> [Vector3; 2] {
        let first = self.direction();
        loop {
            if let Some(second) = first.cross(self.direction()).normalized() {
                return [first, second];
            }
        }
    }
}
