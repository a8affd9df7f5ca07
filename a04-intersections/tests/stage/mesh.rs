//! A closed mesh of triangles lets no ray out, not even between them.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Triangle, World};

/// The corners, relative to the middle, and faces of a sphere of 20 · 4² = 320 triangles.
/// Each corner is moved to another distance from the middle, between `least` and 2, so
/// that faces are crooked and of unlike shapes. From outside, the corners of a face run
/// counterclockwise.
fn bumpy_sphere(seed: u64, least: f64) -> (Vec<Vector3>, Vec<[usize; 3]>) {
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
        let height = least + (2.0 - least) * PixelRandom::new(seed, n, 0).uniform(0);
        corner.normalized().unwrap() * height
    };
    let corners: Vec<_> = (0..).zip(&corners).map(moved).collect();
    for face in &mut faces {
        let [a, b, c] = face.map(|i| corners[i]);
        if a.dot(b.cross(c)) < 0.0 {
            face.swap(0, 1);
        }
    }
    (corners, faces)
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
        let (corners, faces) = bumpy_sphere(7, 1.0);
        assert_eq!((corners.len(), faces.len()), (162, 320));
        let corners: Vec<_> = corners.iter().map(|corner| middle + *corner).collect();
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

/// A random closed mesh: a bumpy sphere, flattened by up to 64 along one axis and by up to
/// 64² along another, at up to 10^6 from the origin.
fn random_mesh(seed: u32) -> (Point3, Vec<Point3>, Vec<[usize; 3]>) {
    let random = PixelRandom::new(61, seed, 0);
    let flat = libm::pow(64.0, -random.uniform(0));
    let away = [0.0, 1.0, 1e3, 1e6][(random.uniform(1) * 4.0) as usize];
    let middle = [2, 3, 4].map(|i| away * (2.0 * random.uniform(i) - 1.0));
    let middle = Point3::from_glam(middle.into());
    let (corners, faces) = bumpy_sphere(u64::from(seed), 0.3);
    let moved = |corner: Vector3| {
        let [x, y, z] = corner.to_glam().to_array();
        let axes = [x, y * flat, z * flat * flat];
        let turned = std::array::from_fn(|axis| axes[(axis + seed as usize) % 3]);
        middle + Vector3::from_glam(turned.into())
    };
    (middle, corners.into_iter().map(moved).collect(), faces)
}

/// Rays at corners and at edges of closed meshes, from inside, from outside and from far
/// away. Only the faces at this corner or edge are tested, so that no other face hides a
/// gap. If the eye is clearly on one side of all of them, they surround the point that the
/// ray aims at, and one of them is hit, whichever way rounding moves the ray.
#[test]
fn no_ray_is_lost_at_an_edge_or_a_corner() {
    // At edges, and at corners.
    let mut rays = [0; 2];
    for seed in 0.. {
        let (middle, corners, faces) = random_mesh(seed);
        let triangle = |face: &[usize; 3]| {
            let [a, b, c] = face.map(|i| corners[i]);
            Triangle::new(a, b, c).unwrap()
        };
        for n in 0..2_000 {
            let random = PixelRandom::new(62, seed, n);
            let face = faces[(random.uniform(0) * 320.0) as usize];
            let is_corner = n % 2 == 0;
            let fan = faces.iter().filter(|other| {
                other.contains(&face[0]) && (is_corner || other.contains(&face[1]))
            });
            let (from, to) = (corners[face[0]], corners[face[1]]);
            let share = if is_corner {
                0.0
            } else {
                0.01 + 0.98 * random.uniform(1)
            };
            let aim = from + (to - from) * share;
            let reach = [0.1, 3.0, 1e3][(random.uniform(2) * 3.0) as usize];
            let way = [3, 4, 5].map(|i| reach * (2.0 * random.uniform(i) - 1.0));
            let eye = middle + Vector3::from_glam(way.into());

            let fan: Vec<_> = fan.collect();
            let side = |face: &&[usize; 3]| {
                let [a, b, c] = face.map(|i| corners[i]);
                let (normal, to_eye) = ((b - a).cross(c - a), eye - aim);
                let cosine = normal.dot(to_eye) / (normal.magnitude() * to_eye.magnitude());
                if cosine.abs() < 1e-3 {
                    0.0
                } else {
                    cosine.signum()
                }
            };
            let sides: Vec<_> = fan.iter().map(side).collect();
            if sides[0] == 0.0 || sides.iter().any(|side| *side != sides[0]) {
                continue;
            }
            let ray = Ray::new(eye, aim - eye).unwrap();
            let is_hit = |face: &&[usize; 3]| triangle(face).hit(&ray, Interval::AHEAD).is_some();
            assert!(fan.iter().any(is_hit), "{ray:?}, mesh {seed}, ray {n}");
            rays[usize::from(is_corner)] += 1;
        }
        if rays.iter().sum::<u32>() >= 1_000_000 {
            println!("{rays:?} rays at edges and corners of {} meshes", seed + 1);
            return;
        }
    }
}

/// Two triangles that share an edge: either may be hit, and the distance is the
/// distance of the edge. Bound: 8 eps of the distance and the coordinates, for the rounded
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
