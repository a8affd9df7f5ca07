//! A camera of rays by random numbers, which differ little or much.
//!
//! A renderer that traces one ray after the other is hard to get wrong. The engine traces bundles of rays through a
//! tree, and decides for a bundle what its rays may meet: so the rays of these cameras come in bundles, some of which
//! differ in nothing but numbers near 0.

use a02_math::arrays::{point, vector};
use a03_rays_cameras::{Camera, Ray};
use common::Size;
use random_scene::{Numbers, Style};
use testing::Random;

/// The rays of a picture of 32 columns, those of 2 rows after each other.
pub struct Rays(pub Vec<Ray>);

impl Camera for Rays {
    /// The engine traces the four rays of a square of pixels together, and its neighbours.
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        let (x, y) = (x as usize, y as usize);
        self.0[(64 * (y / 2) + 4 * (x / 2) + 2 * (y % 2) + x % 2) % self.0.len()]
    }
}

impl Rays {
    /// Bundles of up to 64 rays in the scene of this seed and style.
    pub fn new(seed: u64, style: Style) -> Self {
        let mut random = Random::new(seed);
        let below = &mut |end| random.below(end);
        // As the scene, it begins with its size and its place.
        let numbers = &mut Numbers::new(below, style);
        let mut rays = Vec::new();
        while rays.len() < 1024 {
            let count = numbers.one_of(&[8, 16, 32, 64]);
            let (from, to, way) = (numbers.point(), numbers.point(), numbers.direction());
            let (axis, forwards) = (numbers.below(3), numbers.signed(1.0));
            let kind = numbers.below(6);
            let width = numbers.unit * numbers.one_of(&[0.0, 1e-9, 0.2, 1.0, 3.0]);
            // What stands for 0 along each axis: a 0 of either sign alone, or beside numbers near it.
            let is_exact = [(); 3].map(|()| numbers.below(2) == 0);
            for i in 0..count {
                let mut origin = point(from);
                let mut aside = [0.0; 3];
                aside[(axis + 1) % 3] = width * f64::from(i) / f64::from(count);
                aside[(axis + 2) % 3] = width * f64::from(i % 2) / f64::from(count);
                let near = vector([(); 3].map(|()| numbers.number())) * (width * 1e-3);
                let direction = match kind {
                    // Along an axis, or almost.
                    0 | 1 => vector([0, 1, 2].map(|other| match numbers.almost_zero() {
                        _ if other == axis => forwards,
                        zero if is_exact[other] => 0.0_f64.copysign(zero),
                        zero => zero,
                    })),
                    // Parallel.
                    2 => vector(way),
                    // From an eye to places that are beside each other, or anywhere.
                    3 => point(to) + near - origin,
                    4 => point(numbers.point()) + near - origin,
                    // Anywhere, to a lamp, and from far away.
                    _ => {
                        origin = point(numbers.point());
                        let far = numbers.one_of(&[1.0, 1e4]);
                        let way = point(to) - origin;
                        origin = point(to) - way * far;
                        way
                    }
                };
                let ray = Ray::new(origin + vector(aside), direction);
                rays.push(ray.unwrap_or(Ray::derived(origin, vector([-0.0, 0.0, -1.0]))));
            }
        }
        Self(rays)
    }
}
