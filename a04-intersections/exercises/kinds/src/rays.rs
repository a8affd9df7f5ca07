//! Rays to a shape: of all lengths, from outside, from inside and from far away, just inside and
//! just outside of borders, and in intervals that end at hits.

use a02_math::Point3;
use a02_math::arrays::{point, vector};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercises::Random;

/// Origin and direction of a ray, and the ends of the interval.
pub type RayWithin = ([f64; 3], [f64; 3], f64, f64);

/// The words for a ray in messages.
pub const RAY: &str = "ray from {} along {}, t from {} to {}";

/// The ray and the interval of an input.
#[must_use]
pub fn ray_within((o, d, min, max): RayWithin) -> (Ray, Interval) {
    (Ray::derived(point(o), vector(d)), Interval { min, max })
}

/// The ray with this origin and direction, ahead of its origin.
#[must_use]
pub fn ahead(o: [f64; 3], d: [f64; 3]) -> RayWithin {
    (o, d, 0.0, f64::INFINITY)
}

/// Simple rays to a shape around the origin: along each axis, in longer steps, from inside,
/// away from it, aslant, and with very short and very long directions.
#[must_use]
pub fn simple() -> Vec<RayWithin> {
    let mut rays = Vec::new();
    for x in [0.0, 0.5, 1.0, 2.0, 3.0] {
        for y in [0.0, 0.5, 1.0, 2.0] {
            rays.push(ahead([x, y, 4.0], [0.0, 0.0, -1.0]));
            rays.push(ahead([x, 4.0, y], [0.0, -2.0, 0.0]));
            rays.push(ahead([x, y, 0.25], [0.0, 0.0, 1.0]));
            rays.push(ahead([x, -4.0, y], [0.0, -1.0, 0.0]));
            rays.push(ahead([4.0, x, y], [-1.0, 0.0, 0.0]));
        }
    }
    rays.push(ahead([3.0, 0.0, 0.0], [-1.0, 0.0, 1.0]));
    for length in [1e-18, 1e18] {
        rays.push(ahead([0.5, 0.25, 4.0], [0.0, 0.0, -length]));
        rays.push(ahead([0.5, 4.0, 0.25], [0.0, -length, 0.0]));
        rays.push(ahead([4.0, 0.5, 0.25], [-length, 0.0, 0.0]));
    }
    rays
}

/// Rays along each axis, to both sides, from points.
#[must_use]
pub fn from_points(points: &[[f64; 3]]) -> Vec<RayWithin> {
    let mut rays = Vec::new();
    for point in points {
        for axis in 0..3 {
            for step in [1.0, -1.0] {
                let mut direction = [0.0; 3];
                direction[axis] = step;
                rays.push(ahead(*point, direction));
            }
        }
    }
    rays
}

/// The random points of an attempt to hit a shape.
struct Attempt {
    from: Point3,
    to: Point3,
    aside: Point3,
    /// The length of the direction, relative to the distance of the points.
    length: f64,
}

impl Attempt {
    fn random(random: &mut Random, number: usize, hits: usize) -> Self {
        let [from, to, aside] = [(); 3].map(|()| point(random.triple(6.0)));
        let distance = if number % 4 == 3 { 100.0 } else { 1.0 };
        Self {
            from: to + (from - to) * distance,
            to,
            aside,
            length: if hits < 5 { 1.0 } else { random.scale() },
        }
    }

    fn ray_towards(&self, to: Point3) -> Ray {
        Ray::derived(self.from, (to - self.from) * self.length)
    }

    /// The ray to a point between both points, at this fraction of the way.
    fn ray_between(&self, fraction: f64) -> Ray {
        self.ray_towards(self.to + (self.aside - self.to) * fraction)
    }
}

/// An attempt that has hit the shape.
#[derive(Clone, Copy)]
pub struct Found {
    attempt: usize,
    t: f64,
    /// The fraction of the way aside at which the shape ends.
    border: f64,
}

impl Found {
    /// Finds attempts that hit a shape.
    pub fn search(shape: &dyn Geometry) -> Vec<Self> {
        let is_hit = |ray: Ray| shape.hit(&ray, Interval::AHEAD).is_some();
        let (mut random, mut found) = (Random::new(1), Vec::new());
        for number in 0..2000 {
            let attempt = Attempt::random(&mut random, number, found.len());
            let ray = attempt.ray_towards(attempt.to);
            let Some(Hit { t, .. }) = shape.hit(&ray, Interval::AHEAD) else {
                continue;
            };
            // Between a point that is hit and one that is not, there is a border.
            let (mut border, mut step) = (0.0, 1.0);
            for _ in 0..40 {
                step /= 2.0;
                if is_hit(attempt.ray_between(border + step)) {
                    border += step;
                }
            }
            found.push(Self {
                attempt: number,
                t,
                border,
            });
            if found.len() == 20 {
                break;
            }
        }
        found
    }

    /// The numbers of what is found, for a record.
    #[must_use]
    pub fn numbers(self) -> [f64; 3] {
        [self.attempt as f64, self.t, self.border]
    }

    /// What is found by its numbers.
    #[must_use]
    pub fn of_numbers([attempt, t, border]: [f64; 3]) -> Self {
        let attempt = attempt as usize;
        Self { attempt, t, border }
    }
}

/// Rays from everywhere, by what a search has found: from outside, inside and far away; with
/// directions of all lengths; in intervals that end just before and after a hit; and just
/// inside and outside of a border. No interval begins nearer before a hit than the least step.
#[must_use]
pub fn from_everywhere(found: &[Found], least_step: f64) -> Vec<RayWithin> {
    let (mut random, mut rays) = (Random::new(1), Vec::new());
    let mut add = |ray: &Ray, min, max| {
        let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
        rays.push((o.to_array(), d.to_array(), min, max));
    };
    let (mut number, infinity) = (0, f64::INFINITY);
    for (hits, found) in found.iter().enumerate() {
        while number < found.attempt {
            Attempt::random(&mut random, number, hits);
            number += 1;
        }
        let attempt = Attempt::random(&mut random, number, hits);
        number += 1;
        let (ray, t) = (attempt.ray_towards(attempt.to), found.t);
        add(&ray, 0.0, infinity);
        if hits == 0 {
            for length in [1e-18, 1e18] {
                let ray = Ray::derived(ray.origin(), ray.direction() * length);
                add(&ray, 0.0, infinity);
            }
        }
        add(&Ray::derived(ray.origin(), -ray.direction()), 0.0, infinity);
        for end in [t * (1.0 - 1e-3), t * (1.0 + 1e-6)] {
            add(&ray, 0.0, end);
            let until_hit = (t - end) * ray.direction().magnitude();
            if until_hit < 0.0 || until_hit >= least_step {
                add(&ray, end, infinity);
            }
        }
        // It begins just behind the surface, often inside.
        let behind = Ray::derived(ray.at(t * 1.001), ray.direction());
        add(&behind, 0.0, infinity);
        add(&attempt.ray_between(found.border - 1e-6), 0.0, infinity);
        add(&attempt.ray_between(found.border + 1e-6), 0.0, infinity);
    }
    rays
}
