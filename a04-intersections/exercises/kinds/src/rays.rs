//! Rays to a shape: of all lengths, from outside, from inside and from far away.

use a02_math::arrays::{array, point, vector};
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
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
/// away from it, aslant, within intervals, and with very short and very long directions.
#[must_use]
pub fn simple() -> Vec<RayWithin> {
    let mut rays = Vec::new();
    for x in [-2.0, -0.5, 0.0, 0.5, 1.0, 2.0, 3.0] {
        for y in [-1.0, 0.0, 0.5, 1.0, 2.0] {
            rays.push(ahead([x, y, 4.0], [0.0, 0.0, -1.0]));
            rays.push(ahead([x, 4.0, y], [0.0, -2.0, 0.0]));
            rays.push(ahead([x, y, 0.25], [0.0, 0.0, 1.0]));
            rays.push(ahead([x, -4.0, y], [0.0, -1.0, 0.0]));
            rays.push(ahead([4.0, x, y], [-1.0, 0.0, 0.0]));
        }
    }
    rays.extend(special());
    rays
}

/// Fewer simple rays, for a shape that is not the first: from a few places along each axis, and all others.
#[must_use]
pub fn few() -> Vec<RayWithin> {
    let mut rays = simple();
    rays.truncate(rays.len() - special().len());
    let mut few: Vec<_> = rays.into_iter().skip(2).step_by(4).collect();
    few.extend(special());
    few
}

/// Rays aslant, within intervals, and with very short and very long directions.
fn special() -> Vec<RayWithin> {
    let mut rays = vec![ahead([3.0, 0.0, 0.0], [-1.0, 0.0, 1.0])];
    // An interval that begins in the shape, and one that ends there.
    for direction in [[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]] {
        let origin = array(point([0.25; 3]) - vector(direction) * 4.0);
        rays.push((origin, direction, 3.5, f64::INFINITY));
        rays.push((origin, direction, 0.0, 3.5));
    }
    for length in [1e-18, 1e18] {
        rays.push(ahead([0.5, 0.25, 4.0], [0.0, 0.0, -length]));
        rays.push(ahead([0.5, 4.0, 0.25], [0.0, -length, 0.0]));
        rays.push(ahead([4.0, 0.5, 0.25], [-length, 0.0, 0.0]));
    }
    rays
}

/// A tiny and a huge shape of the same form, and some of the simple rays to them, from as many sizes away. An epsilon
/// would swallow the tiny one, and is nothing beside the huge one.
pub fn of_sizes<P: Clone>(shape: impl Fn(f64) -> P) -> Vec<(P, RayWithin)> {
    let mut rays = Vec::new();
    for size in [1.0 / 1_073_741_824.0, 1_073_741_824.0] {
        for (origin, direction, min, max) in few() {
            let ray = (origin.map(|x| x * size), direction, min * size, max * size);
            rays.push((shape(size), ray));
        }
    }
    rays
}

/// A point on the edge of a shape, as rays of a direction see it, and a vector away from the shape.
pub type Edge = ([f64; 3], [f64; 3], [f64; 3]);

/// Rays along the directions of edges, close to them, inside and outside.
pub fn beside<P: Clone>(shape: &P, edges: &[Edge]) -> Vec<(P, RayWithin)> {
    let mut rays = Vec::new();
    for (on_edge, direction, outwards) in edges {
        for distance in [1e-3, 1e-6, 1e-12, -1e-3, -1e-6, -1e-12] {
            let beside = point(*on_edge) + vector(*outwards) * distance;
            let origin = array(beside - vector(*direction) * 4.0);
            rays.push((shape.clone(), ahead(origin, *direction)));
        }
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

/// Random rays around a point near which a shape is: towards a place there, from near by or far away, in
/// steps of any length; the opposite one; and one from that place on.
#[must_use]
pub fn around(middle: [f64; 3], random: &mut Random) -> [RayWithin; 3] {
    let to = point(middle) + vector(random.triple(1.0));
    let distance = [1.0, 1.0, 1.0, 100.0][random.below(4) as usize];
    let way = vector(random.triple(6.0)) * distance;
    let step = way * random.scale();
    let [from, to] = [to - way, to].map(array);
    [
        ahead(from, array(step)),
        ahead(from, array(-step)),
        ahead(to, array(step)),
    ]
}
