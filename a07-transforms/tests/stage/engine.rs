//! The engine hits transformed shapes and discs as the lesson's nodes do, to the last
//! bit.

use std::f64::consts::PI;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere, Triangle, World};
use a07_transforms::fast::shapes;
use a07_transforms::{Disc, Node, Transform};
use common::Color;

use super::compare::compare;

const RINGS: u32 = 6;

/// A point of the unit sphere between two poles, in a grid of rings.
fn place(ring: u32, step: u32) -> Point3 {
    let polar = PI * f64::from(ring) / f64::from(RINGS);
    let around = 2.0 * PI * f64::from(step % RINGS) / f64::from(RINGS);
    let (sin, cos) = (libm::sin(polar), libm::cos(polar));
    Point3::new(sin * libm::cos(around), cos, sin * libm::sin(around))
}

/// A closed mesh round the origin; the narrow triangles at the poles are left
/// out.
fn mesh(mut node: Node) -> Node {
    for ring in 1..RINGS - 1 {
        for step in 0..RINGS {
            let (a, b) = (place(ring, step), place(ring, step + 1));
            let (c, d) = (place(ring + 1, step), place(ring + 1, step + 1));
            node = node
                .with(Triangle::new(a, b, c).unwrap())
                .with(Triangle::new(b, d, c).unwrap());
        }
    }
    node
}

/// A shape of a student's own.
#[derive(Debug)]
struct Own(Sphere);

impl Geometry for Own {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }
}

fn scaled(s: f64) -> Transform {
    Transform::IDENTITY.scale(s, s, s).unwrap()
}

/// Two meshes, one of them mirrored, stretched and nested, with simpler shapes
/// round about; and as many places worth aiming at, on edges and rims.
fn world(s: f64, far: f64) -> (World<usize>, Vec<Point3>) {
    let at = |x: f64, y: f64| Point3::new(x * s + far, y * s, -far);
    let turned = Transform::IDENTITY
        .translate(at(0.0, 0.0))
        .and_then(|t| t.scale(s, s, s)?.rotate_x(0.7)?.rotate_y(-0.4))
        .unwrap();
    let inner = Transform::IDENTITY
        .scale(-1.0, 0.5, 2.0)
        .and_then(|t| t.rotate_z(1.1))
        .unwrap();
    let outer = Transform::IDENTITY
        .translate(at(3.0, 1.0))
        .and_then(|t| t.scale(s, s, s)?.rotate_y(0.3))
        .unwrap();
    let unit = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let corner = Point3::new(0.5, 0.5, 0.5);
    let cube = AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), corner).unwrap();
    let tilted = Normal3::new(1.0, 2.0, -1.0);
    let disc = Disc::new(at(-2.0, 2.0), tilted, s).unwrap();
    let side = |x, y| Transform::IDENTITY.translate(at(x, y)).unwrap();
    let small = |x, y| side(x, y).scale(s, s, s).unwrap();
    let ellipsoid = side(0.0, 3.0).scale(2.0 * s, 0.1 * s, s).unwrap();
    // So unequal that the engine calls the node's own `hit`.
    let needle = side(0.0, -3.0).scale(2e7 * s, s, s).unwrap();
    let turned_inside = Transform::IDENTITY.rotate_z(0.3).unwrap();

    let nested = Node::new(outer)
        .with(mesh(Node::new(inner)))
        .with(Node::new(scaled(0.3)).with(Own(unit)).with(cube));
    let world = World::new(Color::BLACK)
        .unwrap()
        .with(mesh(Node::new(turned)), 0)
        .with(nested, 1)
        .with(Node::new(small(-3.0, 0.0)).with(cube), 2)
        .with(Node::new(ellipsoid).with(unit), 3)
        .with(disc, 4)
        .with(
            Node::new(needle).with(Node::new(turned_inside).with(unit)),
            5,
        )
        // Where two are met at once, the first of the list counts.
        .with(Node::new(small(-3.0, 0.0)).with(cube), 6);

    let mut targets = Vec::new();
    for ring in 1..RINGS {
        for step in 0..RINGS {
            let (p, q) = (place(ring, step), place(ring, step + 1));
            let edge = p + (q - p) * 0.5;
            for p in [p, edge] {
                targets.push(turned.matrix() * p);
                targets.push(outer.matrix() * (inner.matrix() * p));
                targets.push(ellipsoid.matrix() * p);
            }
        }
    }
    let cube = small(-3.0, 0.0).matrix();
    for i in 0..8 {
        let [x, y, z] = [1, 2, 4].map(|bit| if i & bit == 0 { -0.5 } else { 0.5 });
        targets.push(cube * Point3::new(x, y, z));
    }
    (world, targets)
}

/// From anywhere round about to the targets, to near by, and past them.
fn rays(targets: &[Point3], s: f64) -> impl Iterator<Item = Ray> {
    (0..8_000).map(move |i| {
        let random = PixelRandom::new(7, i, 0);
        let number = |n| 2.0 * random.uniform(n) - 1.0;
        let way = Vector3::new(number(0), number(1), number(2));
        let target = targets[i as usize % targets.len()];
        let target = match i % 3 {
            0 => target,
            1 => target + Vector3::new(number(3), number(4), number(5)) * (1e-9 * s),
            _ => target + Vector3::new(number(3), number(4), number(5)) * s,
        };
        let origin = target + way * (if i % 5 == 0 { 1e4 } else { 6.0 } * s);
        Ray::new(origin, target - origin).unwrap()
    })
}

fn check(s: f64, far: f64) {
    let (world, targets) = world(s, far);
    let mut met = [0; 7];
    let rays: Vec<_> = rays(&targets, s).collect();
    for ray in &rays {
        if let Some((_, surface)) = world.hit(ray, Interval::AHEAD) {
            met[*surface] += 1;
        }
    }
    compare(&world, shapes, &rays);
    // All are met, but the twin of the cube behind it in the list.
    assert!(met[..6].iter().all(|times| *times > 100), "{met:?}");
    assert_eq!(met[6], 0);
}

#[test]
fn nodes_of_all_sizes_and_far_away_are_met_alike() {
    for (s, far) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 1e7)] {
        check(s, far);
    }
}
