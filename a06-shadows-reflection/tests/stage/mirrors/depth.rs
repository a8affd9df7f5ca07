//! How often a ray may be mirrored.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a06_shadows_reflection::ShadowedWorld;
use approx::assert_relative_eq;
use common::Color;

use super::{UP, X, mirror, plane, trace, world};

/// Two mirrors that face each other at this distance, each of the colour 1.
fn corridor(k: f64, gap: f64) -> ShadowedWorld {
    let wall = || mirror(Color::WHITE, Color::gray(k));
    world(Color::BLACK, Color::WHITE)
        .with(plane(Point3::ORIGIN, X), wall())
        .with(plane(Point3::ORIGIN + X * gap, X), wall())
}

/// From half way between the mirrors.
fn along(d: Vector3, gap: f64) -> Ray {
    Ray::new(Point3::ORIGIN + X * (gap / 2.0), d).unwrap()
}

/// 1 + k + k² + .. of `depth` terms is (1 - k^depth) / (1 - k), and `depth` if
/// k is 1. Bound: one rounding each in the power and in the sum, depth eps. A
/// gap below any fixed length that a reflected ray might skip is none the less
/// a gap.
#[test]
fn two_mirrors_show_each_other_in_a_geometric_series() {
    for k in [0.0, 0.5, 0.9, 0.99, 1.0] {
        for depth in [1, 2, 5, 10, 50, 1000] {
            let power: f64 = (0..depth).map(|_| k).product();
            let expected = if k < 1.0 {
                (1.0 - power) / (1.0 - k)
            } else {
                f64::from(depth)
            };
            let bound = f64::from(depth) * 2.0 * f64::EPSILON;
            for gap in [5e-4, 1.0, 1e6] {
                for d in [X, -X, Vector3::new(3.0, -1.0, 2.0)] {
                    let color = trace(&corridor(k, gap), &along(d, gap), depth);
                    assert_relative_eq!(color.r, expected, max_relative = bound);
                    assert_eq!((color.g, color.b), (color.r, color.r));
                }
            }
        }
    }
}

/// A function that calls itself a million times ends the program.
#[test]
fn a_depth_of_a_million_needs_no_stack() {
    let color = trace(&corridor(1.0, 1.0), &along(X, 1.0), 1_000_000);
    assert_eq!(color, Color::gray(1e6));
    // Powers of 1/2 become 0 on the way, and the sum 2.
    let color = trace(&corridor(0.5, 1.0), &along(X, 1.0), 1_000_000);
    assert_eq!(color, Color::gray(2.0));
}

#[test]
fn depth_counts_the_surfaces_that_a_ray_may_meet() {
    let world = world(Color::BLUE, Color::WHITE).with(
        plane(Point3::ORIGIN, UP),
        mirror(Color::gray(0.5), Color::gray(0.5)),
    );
    let down = Ray::new(Point3::new(0.0, 3.0, 0.0), -UP).unwrap();
    assert_eq!(trace(&world, &down, 0), Color::BLACK);
    assert_eq!(trace(&world, &down, 1), Color::gray(0.5));
    let with_sky = Color::gray(0.5) + Color::BLUE * 0.5;
    assert_eq!(trace(&world, &down, 2), with_sky);
    assert_eq!(trace(&world, &down, u32::MAX), with_sky);
    let up = Ray::new(Point3::new(0.0, 3.0, 0.0), UP).unwrap();
    assert_eq!(trace(&world, &up, 0), Color::BLACK);
    assert_eq!(trace(&world, &up, 1), Color::BLUE);
}
