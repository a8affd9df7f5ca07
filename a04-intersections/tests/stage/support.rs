//! Short forms for points, rays and hits, and tables of exact hits.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};

pub fn point(coordinates: [f64; 3]) -> Point3 {
    Point3::from_glam(coordinates.into())
}

pub fn vector(components: [f64; 3]) -> Vector3 {
    Vector3::from_glam(components.into())
}

/// A ray whose direction keeps its length.
pub fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(point(o), vector(d))
}

pub fn hit(shape: &dyn Geometry, ray: &Ray) -> Option<Hit> {
    shape.hit(ray, Interval::AHEAD)
}

/// Origin and direction of a ray, and `t` and normal of its hit.
pub type Case = ([f64; 3], [f64; 3], Option<(f64, [f64; 3])>);

/// Compares the hits of a shape with exact ones.
pub fn assert_hits(shape: &dyn Geometry, cases: &[Case]) {
    for &(o, d, expected) in cases {
        let expected = expected.map(|(t, normal)| Hit::new(t, vector(normal).as_normal()));
        assert_eq!(hit(shape, &ray(o, d)), expected, "{shape:?} {o:?} {d:?}");
    }
}

/// A vector of three random numbers from `-width` to `width`.
pub fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

/// A point of eighths from -2 to 2.
pub fn eighths(random: PixelRandom, first: u64) -> Point3 {
    point([0, 1, 2].map(|i| (33.0 * random.uniform(first + i)).floor() / 8.0 - 2.0))
}

/// Random numbers in a row.
pub struct Numbers(PixelRandom, u64);

impl Numbers {
    pub const fn new(seed: u64) -> Self {
        Self(PixelRandom::new(seed, 0, 0), 0)
    }

    /// From 0 to 1.
    fn uniform(&mut self) -> f64 {
        self.1 += 1;
        self.0.uniform(self.1)
    }

    /// From -1 to 1.
    pub fn next(&mut self) -> f64 {
        2.0 * self.uniform() - 1.0
    }

    /// Three numbers from -1 to 1.
    pub fn vector(&mut self) -> Vector3 {
        vector([0; 3].map(|_| self.next()))
    }

    /// Half of the vectors from -1 to 1 in eighths, so that rays go along axes, through
    /// edges and through corners; half from -8 to 8 in multiples of 2^-20.
    fn rounded_vector(&mut self) -> Vector3 {
        let (width, steps) = if self.uniform() < 0.5 {
            (1.0, 8.0)
        } else {
            (8.0, 1_048_576.0)
        };
        vector([0; 3].map(|_| (steps * width * self.next()).round() / steps))
    }
}

/// The shape with this number: planes, spheres, boxes and triangles in turn.
pub fn random_shape(n: u32) -> Box<dyn Geometry> {
    let mut numbers = Numbers(PixelRandom::new(5, n, 0), 0);
    loop {
        let [a, b, c] = [0; 3].map(|_| Point3::ORIGIN + numbers.rounded_vector());
        match n % 4 {
            0 => {
                if let Ok(plane) = Plane::new(a, numbers.rounded_vector().as_normal()) {
                    return Box::new(plane);
                }
            }
            1 => return Box::new(Sphere::new(a, 0.1 + numbers.uniform()).unwrap()),
            2 => return Box::new(AxisAlignedBox::new(a, b).unwrap()),
            _ => {
                if let Ok(triangle) = Triangle::new(a, b, c) {
                    return Box::new(triangle);
                }
            }
        }
    }
}

/// The ray with this number.
pub fn random_ray(n: u32) -> Ray {
    let mut numbers = Numbers(PixelRandom::new(6, n, 0), 0);
    loop {
        let (from, to) = (numbers.rounded_vector(), numbers.rounded_vector());
        if let Ok(ray) = Ray::new(Point3::ORIGIN + from, to - from) {
            return ray;
        }
    }
}
