//! Rays in the plane of a triangle, up to rounding.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::Triangle;

use super::triangle;
use crate::support::{assert_hits, eighths, hit};

/// A whole number from -16 to 16.
fn whole(random: PixelRandom, n: u64) -> i32 {
    (33.0 * random.uniform(n)) as i32 - 16
}

#[test]
fn rays_in_the_plane_and_parallel_to_it_miss() {
    for zero in [0.0, -0.0] {
        for d in [[1.0, 0.0, zero], [zero, 1.0, zero], [1.0, -1.0, zero]] {
            let parallel = |z| ([-1.0, 2.0, z], d, None);
            assert_hits(&triangle(), &[0.0, -0.0, 0.5].map(parallel));
        }
    }
}

/// Whether the corners (0, 0), (1, 0) and (0, 1), which are (0, 0), (4, 0) and (0, 4) in
/// quarters, lie on one side of the line through two places.
fn passes_beside([px, py]: [i32; 2], [qx, qy]: [i32; 2]) -> bool {
    let side = |x: i32, y: i32| ((qx - px) * (y - py) - (qy - py) * (x - px)).signum();
    let sides = [side(0, 0), side(4, 0), side(0, 4)];
    sides == [1; 3] || sides == [-1; 3]
}

/// A place of the plane, in quarters of two edges, is a multiple of 1/32 of each
/// coordinate: all points are exact, and only the direction of the ray is rounded.
#[test]
fn rays_in_the_plane_beside_a_triangle_miss_it() {
    for n in 0..10_000 {
        let random = PixelRandom::new(41, n, 0);
        let [a, b, c] = [0, 3, 6].map(|first| eighths(random, first));
        let Ok(triangle) = Triangle::new(a, b, c) else {
            continue;
        };
        for line in 0..50 {
            let [p, q] = [0, 2].map(|i| [0, 1].map(|j| whole(random, 10 + 4 * line + i + j)));
            if passes_beside(p, q) {
                let [p, q] = [p, q].map(|[x, y]| {
                    let [x, y] = [x, y].map(|quarters| f64::from(quarters) / 4.0);
                    a + (b - a) * x + (c - a) * y
                });
                let ray = Ray::new(p, q - p).unwrap();
                assert_eq!(hit(&triangle, &ray), None, "{triangle:?} {ray:?}");
            }
        }
    }
}

/// Seen along its plane a triangle has no area, so that a ray may hit or miss it. A ray
/// along an edge hits nothing but the edge, and one through a corner nothing before or
/// behind all corners, to the rounding of depths below 64.
#[test]
fn rays_in_the_plane_hit_edges_and_corners_where_they_are() {
    const ROUNDING: f64 = 64.0 * 16.0 * f64::EPSILON;
    let mut hits = [0, 0];
    for n in 0..20_000 {
        let random = PixelRandom::new(42, n, 0);
        let [a, b, c] = [0, 3, 6].map(|first| eighths(random, first));
        let Ok(triangle) = Triangle::new(a, b, c) else {
            continue;
        };
        let share = f64::from(whole(random, 10)) / 4.0;
        for (from, to, third) in [(a, b, c), (b, c, a), (c, a, b)] {
            let along: Vector3 = to - from;
            let aside = along + (third - from) * share;
            let rays = [(along, vec![from, to]), (aside, vec![a, b, c])];
            for ((way, corners), hits) in rays.into_iter().zip(&mut hits) {
                let eye = from - way * 0.5;
                let Ok(ray) = Ray::new(eye, way) else {
                    continue;
                };
                let Some(hit) = hit(&triangle, &ray) else {
                    continue;
                };
                let depths = corners.iter().map(|p| (*p - eye).dot(ray.direction()));
                let ends = (f64::INFINITY, f64::NEG_INFINITY);
                let (low, high) = depths.fold(ends, |(a, b), t| (a.min(t), b.max(t)));
                let range = low - ROUNDING..=high + ROUNDING;
                assert!(range.contains(&hit.t), "{triangle:?} {ray:?}");
                *hits += 1;
            }
        }
    }
    assert!(hits.iter().all(|hits| *hits > 1000), "both are tested");
}
