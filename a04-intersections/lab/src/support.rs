//! Numbers of either precision, rays, hits and random numbers for experiments and extreme
//! cases.

use a02_math::arrays::array;
use std::ops::{Add, Mul};

pub use a02_math::arrays::{point, vector};
use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use common::ArgumentError;
use num_traits::{Float, NumCast};

use a04_intersections::kinds::{Content, ShapeKind};
use a04_intersections::{Geometry, Interval, Triangle};

pub type Triple = [f64; 3];
/// An origin and a direction.
pub type Line = (Triple, Triple);

/// The ray as in a scene, with a direction of length 1.
pub fn unit_ray((o, d): Line) -> Result<Ray, ArgumentError> {
    Ray::new(point(o), vector(d))
}

/// The ray as in the protocol: unchecked.
pub const fn raw_ray((o, d): Line) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The ray as in a scene, or unchecked if `Ray::new` refuses it.
pub fn any_ray(line: Line) -> Ray {
    unit_ray(line).unwrap_or(raw_ray(line))
}

/// Origin and direction as arrays, the arguments of formulas in both precisions.
pub fn arrays(ray: &Ray) -> [Triple; 2] {
    [array(ray.origin()), array(ray.direction())]
}

/// The numbers of a shape under a key of its table in a scene file; NaN if it has not so many.
pub fn numbers<const N: usize>(shape: &impl ShapeKind, key: &str) -> [f64; N] {
    let values = match shape.content() {
        Content::Values(values) => values,
        Content::Children { .. } => Vec::new(),
    };
    let mut values = values.into_iter().filter(|(name, _)| *name == key);
    let found = values
        .next()
        .and_then(|(_, numbers)| numbers.try_into().ok());
    found.unwrap_or([f64::NAN; N])
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

/// The condition of a hit's `t`: by how many units in its last place it changes, if each number of
/// ray and surface changes by one. If a surface of the normal `n` is moved by δs and the ray by δo
/// and δd, the hit moves by `δt = n · (δs - δo - t δd) / (n · d)`. The numbers that move the surface
/// along each axis add up to `surface`.
fn condition(n: Triple, surface: Triple, [o, d]: &[Triple; 2], t: f64) -> f64 {
    let moved = |i: usize| n[i].abs() * (surface[i] + o[i].abs() + (t * d[i]).abs());
    ((0..3).map(moved).sum::<f64>() / (dot(&n, d) * t)).abs()
}

/// The condition at a hit of a sphere, whose radius moves it along the normal.
pub fn sphere_condition(c: &Triple, r: f64, line: &[Triple; 2], t: f64) -> f64 {
    let n = std::array::from_fn(|i| (line[0][i] - c[i] + t * line[1][i]) / r);
    condition(
        n,
        std::array::from_fn(|i| c[i].abs() + r * n[i].abs()),
        line,
        t,
    )
}

/// The condition at a hit of a plane, which its normal turns around its point.
pub fn plane_condition(a: &Triple, n: Triple, line @ [o, d]: &[Triple; 2], t: f64) -> f64 {
    let moved = |i: usize| a[i].abs() + (o[i] + t * d[i] - a[i]).abs();
    condition(n, std::array::from_fn(moved), line, t)
}

/// The condition at a hit of a triangle, whose corners move it by their fractions.
pub fn triangle_condition(
    corners: &[Triple; 3],
    [beta, gamma]: [f64; 2],
    line: &[Triple; 2],
    t: f64,
) -> f64 {
    let [a, b, c] = corners.map(vector);
    let n = array((b - a).cross(c - a));
    let fractions = [1.0 - beta - gamma, beta, gamma];
    let moved = |i: usize| {
        (0..3)
            .map(|k: usize| (fractions[k] * corners[k][i]).abs())
            .sum()
    };
    condition(n, std::array::from_fn(moved), line, t)
}

/// `f32` or `f64`, for formulas in either precision.
pub trait Real: Float + Into<f64> {
    /// The number nearest to a double.
    fn rounded(number: f64) -> Self {
        <Self as NumCast>::from(number).unwrap_or_else(Self::nan)
    }
}

impl<F: Float + Into<f64>> Real for F {}

pub fn difference<F: Real>(a: &[F; 3], b: &[F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot<F: Copy + Add<Output = F> + Mul<Output = F>>(a: &[F; 3], b: &[F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
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
