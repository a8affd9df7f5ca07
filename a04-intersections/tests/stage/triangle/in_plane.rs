//! Rays in the plane of a triangle, up to rounding, that pass beside it.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Triangle};

/// A whole number from -16 to 16.
fn whole(random: PixelRandom, n: u64) -> i32 {
    (33.0 * random.uniform(n)) as i32 - 16
}

/// A point or vector of eighths.
fn eighths(random: PixelRandom, first: u64) -> Vector3 {
    let [x, y, z] = [0, 1, 2].map(|i| f64::from(whole(random, first + i)) / 8.0);
    Vector3::new(x, y, z)
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
    let mut rays = 0;
    for n in 0.. {
        let random = PixelRandom::new(41, n, 0);
        let (a, b, c) = (eighths(random, 0), eighths(random, 3), eighths(random, 6));
        let corner = |v: Vector3| Point3::ORIGIN + v;
        let Ok(triangle) = Triangle::new(corner(a), corner(b), corner(c)) else {
            continue;
        };
        for line in 0..50 {
            let [p, q] = [0, 2].map(|i| [0, 1].map(|j| whole(random, 10 + 4 * line + i + j)));
            if !passes_beside(p, q) {
                continue;
            }
            let [p, q] = [p, q].map(|[x, y]| {
                let [x, y] = [x, y].map(|quarters| f64::from(quarters) / 4.0);
                corner(a + (b - a) * x + (c - a) * y)
            });
            let ray = Ray::new(p, q - p).unwrap();
            assert_eq!(
                triangle.hit(&ray, Interval::AHEAD),
                None,
                "{triangle:?} {ray:?}"
            );
            rays += 1;
        }
        if rays >= 1_000_000 {
            return;
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
        let [a, b, c] = [0, 3, 6].map(|i| Point3::ORIGIN + eighths(random, i));
        let Ok(triangle) = Triangle::new(a, b, c) else {
            continue;
        };
        let share = f64::from(whole(random, 10)) / 4.0;
        for (from, to, third) in [(a, b, c), (b, c, a), (c, a, b)] {
            let along = to - from;
            let aside = along + (third - from) * share;
            let rays = [(along, vec![from, to]), (aside, vec![a, b, c])];
            for ((way, corners), hits) in rays.into_iter().zip(&mut hits) {
                let eye = from - way * 0.5;
                let Ok(ray) = Ray::new(eye, way) else {
                    continue;
                };
                let Some(hit) = triangle.hit(&ray, Interval::AHEAD) else {
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

/// Found by an audit: it was hit 1.75 edges beside the triangle.
#[test]
fn a_ray_in_the_plane_misses_by_far() {
    let triangle = Triangle::new(
        Point3::new(-0.25, -2.5, -4.0),
        Point3::new(2.5, -2.5, -3.75),
        Point3::new(-3.0, -1.75, -4.0),
    );
    let direction = Vector3::new(
        0.562_808_961_106_316,
        0.767_466_765_144_976_2,
        0.306_986_726_057_980_5,
    );
    let ray = Ray::derived(Point3::new(6.625, -4.375, -4.0), direction);
    assert_eq!(triangle.unwrap().hit(&ray, Interval::AHEAD), None);
}
