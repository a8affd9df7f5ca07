//! Rays in the plane of a triangle: rounding alone decides whether and where they hit it,
//! also outside of its bounds. With more than sixteen triangles the engine builds a tree.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Interval, Triangle, World};
use common::Color;

use super::compare::{compare, prepared};

/// A vector of eighths from -2 to 2.
fn eighths(random: PixelRandom, first: u64) -> Vector3 {
    let [x, y, z] = [0, 1, 2].map(|i| (33.0 * random.uniform(first + i)).floor() / 8.0 - 2.0);
    Vector3::new(x, y, z)
}

#[test]
fn rays_in_the_plane_of_a_triangle_are_decided_as_in_the_list() {
    const TRIANGLES: u64 = 20;
    let (mut hits, mut count) = (0, 0);
    for seed in 0..400 {
        let random = PixelRandom::new(seed, 0, 0);
        let corners = (0..TRIANGLES).map(|i| [0, 3, 6].map(|n| eighths(random, 9 * i + n)));
        let corners: Vec<_> = corners
            .filter(|corners| {
                let [a, b, c] = corners.map(|corner| Point3::ORIGIN + corner);
                Triangle::new(a, b, c).is_ok()
            })
            .collect();
        let world = corners.iter().enumerate().fold(
            World::new(Color::BLACK).unwrap(),
            |world, (i, corners)| {
                let [a, b, c] = corners.map(|corner| Point3::ORIGIN + corner);
                world.with(Triangle::new(a, b, c).unwrap(), i)
            },
        );
        let mut rays = Vec::new();
        for [a, b, c] in corners {
            // From a point of the plane beside the triangle to points around its middle.
            let at = |beta: f64, gamma: f64| a + (b - a) * beta + (c - a) * gamma;
            let from = at(2.5, 1.25);
            for beta in [0.125, 0.25, 1.0 / 3.0, 0.5] {
                for gamma in [0.125, 0.25, 1.0 / 3.0, 0.5] {
                    let to = at(beta, gamma) - from;
                    rays.push((
                        Ray::new(Point3::ORIGIN + from, to).unwrap(),
                        Interval::AHEAD,
                    ));
                }
            }
        }
        hits += compare(&world, &prepared(&world), &rays);
        count += rays.len();
    }
    assert!((count / 10..count).contains(&hits), "{hits} of {count}");
}
