//! A closed mesh of triangles lets no ray out, not even between them.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Triangle, World};

/// The corners and faces of a sphere of 20 · 4² = 320 triangles. Each corner
/// is moved to another distance from the middle, from 1 to 2, so that faces are
/// crooked and of unlike shapes.
fn bumpy_sphere(middle: Point3) -> (Vec<Point3>, Vec<[usize; 3]>) {
    let golden = f64::midpoint(1.0, 5_f64.sqrt());
    let mut corners = Vec::new();
    for (one, more) in [
        (1.0, golden),
        (-1.0, golden),
        (1.0, -golden),
        (-1.0, -golden),
    ] {
        corners.push(Vector3::new(0.0, one, more));
        corners.push(Vector3::new(one, more, 0.0));
        corners.push(Vector3::new(more, 0.0, one));
    }
    // The faces of an icosahedron: all triples of corners at distance 2.
    let near = |i: usize, j: usize| (corners[i] - corners[j]).magnitude() < 2.1;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in (0..i).filter(|&j| near(i, j)) {
            faces.extend(
                (0..j)
                    .filter(|&k| near(i, k) && near(j, k))
                    .map(|k| [i, j, k]),
            );
        }
    }
    for _ in 0..2 {
        let mut middles = std::collections::HashMap::new();
        let mut halve = |i: usize, j: usize| {
            *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                corners.push((corners[i] + corners[j]) * 0.5);
                corners.len() - 1
            })
        };
        let quarters = |[a, b, c]: [usize; 3]| {
            let [ab, bc, ca] = [halve(a, b), halve(b, c), halve(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(quarters).collect();
    }
    let moved = |(n, corner): (u32, &Vector3)| {
        let height = 1.0 + PixelRandom::new(7, n, 0).uniform(0);
        middle + corner.normalized().unwrap() * height
    };
    ((0..).zip(&corners).map(moved).collect(), faces)
}

/// Random rays meet edges almost never and would prove nothing: these aim at
/// corners, at middles of edges and at other points of edges, from places near
/// the middle, from where the whole surface is seen. The second place is far
/// from the origin, where coordinates are coarse.
#[test]
fn no_ray_leaves_a_closed_mesh() {
    for middle in [
        Point3::ORIGIN,
        Point3::new(148_376.0, 1234.0, -223_423.0),
        Point3::new(1e9, -1e9, 1e9),
    ] {
        let (corners, faces) = bumpy_sphere(middle);
        assert_eq!((corners.len(), faces.len()), (162, 320));
        let world = faces
            .iter()
            .fold(World::new(common::Color::BLACK).unwrap(), |world, f| {
                let [a, b, c] = f.map(|i| corners[i]);
                world.with(Triangle::new(a, b, c).unwrap(), ())
            });
        let mut leaks = 0;
        for n in 0..12_000_u32 {
            let random = PixelRandom::new(8, n, 0);
            let face = faces[(random.uniform(0) * 320.0) as usize];
            let side = (random.uniform(1) * 3.0) as usize;
            let share = [0.0, 0.5, random.uniform(2)][n as usize % 3];
            let (from, to) = (corners[face[side]], corners[face[(side + 1) % 3]]);
            let aim = from + (to - from) * share;
            let offset = [3, 4, 5].map(|i| 0.2 * random.uniform(i) - 0.1);
            let eye = middle + Vector3::from_glam(offset.into());
            let ray = Ray::new(eye, aim - eye).unwrap();
            leaks += u32::from(!world.is_hit(&ray, Interval::AHEAD));
        }
        assert_eq!(leaks, 0, "around {middle:?}");
    }
}

/// Two triangles that share an edge: whichever is hit, the distance is that of
/// the edge. Bound: 8 eps of the distance and the coordinates, for the rounded
/// ray and a few operations.
#[test]
fn a_shared_edge_is_met_at_the_same_distance_on_both_sides() {
    let [a, b] = [Point3::new(0.1, -1.0, 0.3), Point3::new(0.7, 1.0, 0.9)];
    let left = Triangle::new(a, b, Point3::new(-2.0, 0.2, 0.1)).unwrap();
    let right = Triangle::new(b, a, Point3::new(2.0, 0.1, 0.4)).unwrap();
    let eye = Point3::new(0.2, 0.1, 5.0);
    let mut met = [0, 0];
    for n in 0..2000 {
        let aim = a + (b - a) * ((f64::from(n) + 0.5) / 2000.0);
        let ray = Ray::new(eye, aim - eye).unwrap();
        let hits = [left, right].map(|side| side.hit(&ray, Interval::AHEAD));
        assert!(hits.iter().any(Option::is_some));
        for (met, hit) in met.iter_mut().zip(hits) {
            let Some(hit) = hit else { continue };
            let distance = (aim - eye).magnitude();
            assert!((hit.t - distance).abs() <= 8.0 * f64::EPSILON * distance);
            *met += 1;
        }
    }
    assert!(met.iter().all(|met| *met > 0), "both sides are tested");
}
