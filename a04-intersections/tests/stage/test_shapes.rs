//! Short forms for points, rays and hits, tables of exact hits, and random shapes and rays.

pub use a02_math::arrays::{point, vector};
use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use common::ArgumentError;
use testing::Random;

/// A ray whose direction keeps its length.
pub fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The nearest hit of a shape ahead of the ray's origin.
pub fn hit(shape: &dyn Geometry, ray: &Ray) -> Option<Hit> {
    shape.hit(ray, Interval::AHEAD)
}

/// Origin and direction of a ray, and `t` and normal of its hit.
pub type Case = ([f64; 3], [f64; 3], Option<(f64, [f64; 3])>);

/// Compares the hits of a shape with exact ones.
pub fn assert_hits(shape: &dyn Geometry, cases: &[Case]) {
    for &(o, d, expected) in cases {
        let expected = expected.map(|(t, normal)| Hit::new(t, vector(normal).as_normal()));
        let found = hit(shape, &ray(o, d)).map(|hit| hit.with_scale(0.0));
        assert_eq!(found, expected, "{shape:?} {o:?} {d:?}");
    }
}

/// A vector of three random numbers from `-width` to `width`.
pub fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

/// A vector of random multiples of `1 / steps` from `-width` to `width`.
fn grid_vector(random: &mut Random, width: u32, steps: u32) -> Vector3 {
    let [x, y, z] = [(); 3].map(|()| random.below(2 * width * steps + 1));
    vector([x, y, z].map(|count| f64::from(count) / f64::from(steps) - f64::from(width)))
}

/// A point of eighths from -2 to 2.
pub fn eighths(random: &mut Random) -> Point3 {
    Point3::ORIGIN + grid_vector(random, 2, 8)
}

/// Half of the vectors from -1 to 1 in eighths, so that rays go along axes, through edges
/// and through corners; half from -8 to 8 in multiples of 2^-20.
fn any_vector(random: &mut Random) -> Vector3 {
    match random.below(2) {
        0 => grid_vector(random, 1, 8),
        _ => grid_vector(random, 8, 1 << 20),
    }
}

/// Planes, spheres, boxes and triangles in turn, half of these with normals of their own.
fn any_shape(n: u32, random: &mut Random) -> Result<Box<dyn Geometry>, ArgumentError> {
    let [a, b, c] = [(); 3].map(|()| Point3::ORIGIN + any_vector(random));
    let normals = [(); 3].map(|()| any_vector(random).as_normal());
    Ok(match n % 8 {
        0 | 4 => Box::new(Plane::new(a, normals[0])?),
        1 | 5 => Box::new(Sphere::new(a, random.between(0.1, 1.1))?),
        2 | 6 => Box::new(AxisAlignedBox::new(a, b)?),
        3 => Box::new(Triangle::new(a, b, c)?),
        _ => Box::new(Triangle::new(a, b, c)?.with_normals(normals)?),
    })
}

/// The shape with this number.
pub fn random_shape(n: u32) -> Box<dyn Geometry> {
    let random = &mut Random::new(u64::from(n));
    loop {
        if let Ok(shape) = any_shape(n, random) {
            return shape;
        }
    }
}

/// The ray with this number, from other random numbers than the shapes.
pub fn random_ray(n: u32) -> Ray {
    let random = &mut Random::new(!u64::from(n));
    loop {
        let (from, to) = (any_vector(random), any_vector(random));
        if let Ok(ray) = Ray::new(Point3::ORIGIN + from, to - from) {
            return ray;
        }
    }
}
