//! The engine hits transformed shapes and discs as the lesson's nodes do, to the last bit.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::kinds::Shared;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere, Triangle, World};
use a04_lab::support::Numbers;
use a07_transforms::kinds::KINDS;
use a07_transforms::{Disc, Mat4x4, Node, Transform};
use common::{ArgumentError, Color};

use crate::same_hits::compare;

/// A shape of a student's own.
#[derive(Debug)]
struct Own(Sphere);

impl Geometry for Own {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }
}

fn point(numbers: &mut Numbers) -> Point3 {
    Point3::ORIGIN + numbers.triple(-1.0, 1.0)
}

/// Translates, turns, stretches and mirrors. One in eight stretches so unequally that the engine
/// calls the node's own `hit`.
fn transform(numbers: &mut Numbers) -> Result<Transform, ArgumentError> {
    let [x, y, z] = [(); 3].map(|()| libm::exp2(numbers.between(-1.0, 1.0)));
    let thin = if numbers.below(8) == 0 { 2e7 } else { 1.0 };
    Transform::IDENTITY
        .translate(point(numbers))?
        .rotate_x(numbers.between(-3.0, 3.0))?
        .rotate_z(numbers.between(-3.0, 3.0))?
        .scale(x * thin, -y, z)
}

/// Adds random shapes to a node, some under nodes of their own; and places worth aiming at, in the
/// space that the matrix leads to: corners, and points on edges and spheres.
fn fill(
    mut node: Node,
    to_world: Mat4x4,
    levels: usize,
    numbers: &mut Numbers,
    targets: &mut Vec<Point3>,
) -> Result<Node, ArgumentError> {
    for _ in 0..3 {
        let kind = numbers.below(6);
        if levels > 0 && kind < 3 {
            let inner = transform(numbers)?;
            let to_world = to_world * inner.matrix();
            let inner = fill(Node::new(inner), to_world, levels - 1, numbers, targets)?;
            node = node.with(inner);
            continue;
        }
        let [a, b, c] = [(); 3].map(|()| point(numbers));
        let radius = numbers.between(0.1, 0.5);
        let (ball, on_ball) = (Sphere::new(a, radius)?, a + numbers.direction() * radius);
        node = match kind {
            0 => node.with(Own(ball)),
            1 => node.with(AxisAlignedBox::new(a, b)?),
            2 => node.with(Disc::new(a, (b - a).as_normal(), 0.5)?),
            3 => node.with(ball),
            // Two triangles with an edge in common.
            _ => node
                .with(Triangle::new(a, b, c)?)
                .with(Triangle::new(b, a, Point3::ORIGIN)?),
        };
        targets.extend([a, b, on_ball, a + (b - a) * 0.5].map(|target| to_world * target));
    }
    Ok(node)
}

/// A world of nodes of this size, this far away. Each stands there twice: the first counts.
fn check(seed: u64, size: f64, far: f64) -> Result<(), ArgumentError> {
    let place = Transform::IDENTITY
        .translate(Point3::new(far, 0.0, -far))?
        .scale(size, size, size)?;
    let (mut world, mut targets) = (World::new(Color::BLACK)?, Vec::new());
    for i in 0..8 {
        let (numbers, node) = (&mut Numbers::new(seed, i / 2), Node::new(place));
        let node = fill(node, place.matrix(), 2, numbers, &mut targets)?;
        world = world.with(node, i);
    }
    let numbers = &mut Numbers::new(seed, 99);
    let mut rays = Vec::new();
    for i in 0..3_000 {
        // To a target, near by, and past it.
        let off = numbers.triple(-1.0, 1.0) * (size * [0.0, 1e-9, 1.0][i % 3]);
        let target = targets[numbers.below(targets.len())] + off;
        let distance = if i % 5 == 0 { 1e4 } else { 6.0 };
        let way: Vector3 = numbers.direction() * (size * distance);
        rays.push(Ray::new(target + way, -way)?);
    }
    let hits = compare(&world, KINDS, &rays);
    assert!((1_000..3_000).contains(&hits), "{hits}");
    Ok(())
}

/// A use of shared shapes under a random transform, this many times as large, and its targets.
fn used(
    shared: &(Shared, Vec<Point3>),
    size: f64,
    numbers: &mut Numbers,
    targets: &mut Vec<Point3>,
) -> Result<Node, ArgumentError> {
    let place = transform(numbers)?.scale(size, size, size)?;
    let (shapes, of_shapes) = shared;
    targets.extend(of_shapes.iter().map(|target| place.matrix() * *target));
    Ok(Node::new(place).with(shapes.clone()))
}

/// Some shapes that stand in several places, themselves in such shapes, in a world that is this
/// many times as large or small.
fn check_shared(seed: u64, size: f64) -> Result<(), ArgumentError> {
    let numbers = &mut Numbers::new(seed, 7);
    let mut of_shapes = Vec::new();
    let mut shapes: Vec<Box<dyn Geometry>> = Vec::new();
    for _ in 0..10 {
        let [a, b, c] = [(); 3].map(|()| point(numbers));
        let ball = Sphere::new(a, 0.3)?;
        of_shapes.extend([a, b, c, a + (b - a) * 0.5]);
        shapes.push(Box::new(Triangle::new(a, b, c)?));
        shapes.push(Box::new(Triangle::new(b, a, Point3::ORIGIN)?));
        shapes.push(Box::new(ball));
        let node = Node::new(Transform::IDENTITY);
        let node = fill(node, Mat4x4::IDENTITY, 1, numbers, &mut of_shapes)?;
        shapes.push(Box::new(node));
    }
    let inner = (Shared::new(shapes, KINDS), of_shapes);
    let (mut shapes, mut of_shapes) = (Vec::<Box<dyn Geometry>>::new(), Vec::new());
    for factor in [0.1, 1.0, 3.0] {
        shapes.push(Box::new(used(&inner, factor, numbers, &mut of_shapes)?));
    }
    shapes.push(Box::new(Disc::new(
        Point3::ORIGIN,
        (point(numbers) - Point3::ORIGIN).as_normal(),
        0.5,
    )?));
    let outer = (Shared::new(shapes, KINDS), of_shapes);
    let (mut world, mut targets) = (World::new(Color::BLACK)?, Vec::new());
    for i in 0..3 {
        world = world.with(used(&inner, size, numbers, &mut targets)?, i);
        world = world.with(used(&outer, size, numbers, &mut targets)?, i + 3);
    }
    // The same use once more: the first counts.
    let numbers = &mut Numbers::new(seed, 8);
    for i in 6..8 {
        world = world.with(
            used(&outer, size, &mut Numbers::new(seed, 9), &mut targets)?,
            i,
        );
    }
    let mut rays = Vec::new();
    for i in 0..3_000 {
        let off = numbers.triple(-1.0, 1.0) * (size * [0.0, 1e-9, 1.0][i % 3]);
        let target = targets[numbers.below(targets.len())] + off;
        let way: Vector3 = numbers.direction() * (size * [6.0, 1e4][i % 2]);
        rays.push(Ray::new(target + way, -way)?);
    }
    let hits = compare(&world, KINDS, &rays);
    assert!((1_000..=3_000).contains(&hits), "{hits}");
    Ok(())
}

#[test]
fn shared_shapes_are_met_alike() {
    for (seed, size) in (10..).zip([1.0, 1e-6, 1e6]) {
        check_shared(seed, size).unwrap();
    }
}

#[test]
fn nodes_of_all_sizes_and_far_away_are_met_alike() {
    let places = [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 1e7)];
    for (seed, (size, far)) in (0..).zip(places) {
        check(seed, size, far).unwrap();
    }
}
