//! Worlds of transformed objects, prepared and not: rays meet the same, to the
//! last bit.

use std::f64::consts::PI;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Sphere, Triangle, World};
use a07_transforms::{Disc, Node, Transform};
use common::Color;

const RINGS: u32 = 8;

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

    let nested = Node::new(outer)
        .with(mesh(Node::new(inner)))
        .with(Node::new(scaled(0.3)).with(unit).with(cube));
    let world = World::new(Color::BLACK)
        .unwrap()
        .with(mesh(Node::new(turned)), 0)
        .with(nested, 1)
        .with(Node::new(small(-3.0, 0.0)).with(cube), 2)
        .with(Node::new(ellipsoid).with(unit), 3)
        .with(disc, 4)
        // Where two are met at once, the first of the list counts.
        .with(Node::new(small(-3.0, 0.0)).with(cube), 5);

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
    targets.extend(
        a04_intersections::Bounds::around([corner, Point3::new(-0.5, -0.5, -0.5)])
            .corners()
            .map(|corner| cube * corner),
    );
    (world, targets)
}

/// From anywhere round about to the targets, to near by, and past them.
fn rays(targets: &[Point3], s: f64) -> impl Iterator<Item = Ray> {
    (0..100_000).map(move |i| {
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
    let (plain, targets) = world(s, far);
    let prepared = world(s, far).0.prepared([]);
    let mut met = [0; 6];
    for ray in rays(&targets, s) {
        let [a, b] = [&plain, &prepared].map(|world| world.hit(&ray, Interval::AHEAD));
        assert_eq!(a, b, "{ray:?}");
        if let (Some((a, surface)), Some((b, _))) = (a, b) {
            assert_eq!(a.t.to_bits(), b.t.to_bits());
            met[*surface] += 1;
            let before = Interval::before(a.t);
            assert!(!prepared.is_hit(&ray, before));
        }
        let is_hit = |world: &World<_>| world.is_hit(&ray, Interval::AHEAD);
        assert_eq!(is_hit(&prepared), a.is_some());
    }
    // All are met, but the twin of the cube behind it in the list.
    assert!(met[..5].iter().all(|times| *times > 100), "{met:?}");
    assert_eq!(met[5], 0);
}

#[test]
fn nodes_are_met_alike() {
    check(1.0, 0.0);
}

#[test]
fn tiny_nodes_are_met_alike() {
    check(1e-6, 0.0);
}

#[test]
fn huge_nodes_are_met_alike() {
    check(1e6, 0.0);
}

#[test]
fn nodes_far_from_the_origin_are_met_alike() {
    check(1.0, 1e7);
}

/// What is hit lies within the bounds, however a node moves it: up to the error
/// of the hit itself, a few units of the largest number in it.
#[test]
fn hits_of_a_node_lie_within_its_bounds() {
    for s in [1e-6, 1.0, 1e6] {
        let (world, targets) = world(s, 0.0);
        let rays: Vec<_> = rays(&targets, s).step_by(10).collect();
        for (geometry, _) in world.objects() {
            let bounds = geometry.bounds();
            assert!(bounds.are_finite());
            for ray in &rays {
                let Some(hit) = geometry.hit(ray, Interval::AHEAD) else {
                    continue;
                };
                let p = ray.at(hit.t);
                let error = 64.0 * f64::EPSILON * hit.t.max(p.largest_coordinate());
                let bounds = bounds.wider(error);
                for (axis, x) in [p.x(), p.y(), p.z()].into_iter().enumerate() {
                    assert!(
                        (bounds.min[axis]..=bounds.max[axis]).contains(&x),
                        "{ray:?}"
                    );
                }
            }
        }
    }
}

/// A disc reaches as far as its rim: with the normal (1, 2, 2) / 3 and radius 3
/// along x 3 √(1 - 1/9) = √8, along y and z 3 √(1 - 4/9) = √5. Bound: a few
/// roundings, and the 2^-40 radii that are added.
#[test]
fn a_disc_reaches_as_far_as_its_rim() {
    let n = Normal3::new(1.0, 2.0, 2.0);
    let bounds = Disc::new(Point3::new(1.0, 2.0, 3.0), n, 3.0)
        .unwrap()
        .bounds();
    let [x, y] = [8_f64, 5.0].map(f64::sqrt);
    for (axis, (c, reach)) in [(1.0, x), (2.0, y), (3.0, y)].into_iter().enumerate() {
        let (below, above) = (c - reach - bounds.min[axis], bounds.max[axis] - c - reach);
        for slack in [below, above] {
            assert!((0.0..4e-12).contains(&slack), "{slack}");
        }
    }
}

/// A node whose condition is beyond all bounds is asked by every ray, and what
/// has no end has none when it is moved.
#[test]
fn a_node_that_cannot_say_where_it_is_says_everywhere() {
    let unit = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let skewed = Transform::IDENTITY
        .rotate_x(0.5)
        .and_then(|t| t.scale(1e4, 1e-4, 1.0))
        .unwrap();
    assert!(!Node::new(skewed).with(unit).bounds().are_finite());
    let floor = a04_intersections::Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0));
    let node = Node::new(scaled(2.0)).with(floor.unwrap());
    assert!(!node.bounds().are_finite());
    assert!(Node::new(scaled(2.0)).parts().is_none());
}
