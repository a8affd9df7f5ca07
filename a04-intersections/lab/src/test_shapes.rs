//! Short forms for points, rays and hits, tables of exact hits, and random shapes and rays, for the tests
//! of this stage and of those above.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use common::ArgumentError;

use crate::support::Numbers;
pub use crate::support::{point, vector};

/// A ray whose direction keeps its length.
#[must_use]
pub fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The nearest hit of a shape ahead of the ray's origin.
#[must_use]
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
#[must_use]
pub fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

/// A point of eighths from -2 to 2.
pub fn eighths(numbers: &mut Numbers) -> Point3 {
    point([(); 3].map(|()| numbers.between(-16.0, 17.0).floor() / 8.0))
}

/// Half of the vectors from -1 to 1 in eighths, so that rays go along axes, through edges
/// and through corners; half from -8 to 8 in multiples of 2^-20.
fn rounded(numbers: &mut Numbers) -> Vector3 {
    let (width, steps) = [(1.0, 8.0), (8.0, 1_048_576.0)][numbers.below(2)];
    vector([(); 3].map(|()| (numbers.between(-width, width) * steps).round() / steps))
}

/// Planes, spheres, boxes and triangles in turn, half of these with normals of their own.
fn any_shape(n: u32, numbers: &mut Numbers) -> Result<Box<dyn Geometry>, ArgumentError> {
    let [a, b, c] = [(); 3].map(|()| Point3::ORIGIN + rounded(numbers));
    let normals = [(); 3].map(|()| rounded(numbers).as_normal());
    Ok(match n % 8 {
        0 | 4 => Box::new(Plane::new(a, normals[0])?),
        1 | 5 => Box::new(Sphere::new(a, numbers.between(0.1, 1.1))?),
        2 | 6 => Box::new(AxisAlignedBox::new(a, b)?),
        3 => Box::new(Triangle::new(a, b, c)?),
        _ => Box::new(Triangle::new(a, b, c)?.with_normals(normals)?),
    })
}

/// The shape with this number.
#[must_use]
pub fn random_shape(n: u32) -> Box<dyn Geometry> {
    let numbers = &mut Numbers::new(5, n as usize);
    let mut shapes = std::iter::repeat_with(|| any_shape(n, numbers));
    shapes.find_map(Result::ok).unwrap()
}

/// The ray with this number.
#[must_use]
pub fn random_ray(n: u32) -> Ray {
    let numbers = &mut Numbers::new(6, n as usize);
    let mut rays = std::iter::repeat_with(|| {
        let (from, to) = (rounded(numbers), rounded(numbers));
        Ray::new(Point3::ORIGIN + from, to - from)
    });
    rays.find_map(Result::ok).unwrap()
}
