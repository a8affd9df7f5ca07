//! The nearest of the children of a node, and trees of nodes.

use a02_math::{Direction, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere, World};
use a07_transforms::{Node, Transform};
use approx::assert_abs_diff_eq;
use common::Color;

use super::{AHEAD, ahead, hit, rays, scaled, translated, unit_sphere};

/// A unit sphere scaled by `r`, its front at z = `-distance`.
fn sphere_ahead(distance: f64, r: f64) -> Node {
    let transform = translated(0.0, 0.0, -distance - r);
    Node::new(transform.scale(r, r, r).unwrap()).with(unit_sphere())
}

/// Children at a distance of 4, and of 5 in a space ten times as large: there
/// the second is only half a unit away.
#[test]
fn distances_in_different_spaces_can_be_compared() {
    let (near, far) = (|| sphere_ahead(4.0, 1.0), || sphere_ahead(5.0, 10.0));
    for node in [
        Node::new(Transform::IDENTITY).with(near()).with(far()),
        Node::new(Transform::IDENTITY).with(far()).with(near()),
        // In half the world, all is twice as far and as large as there.
        Node::new(scaled(0.5, 0.5, 0.5))
            .with(sphere_ahead(10.0, 20.0))
            .with(sphere_ahead(8.0, 2.0)),
    ] {
        let found = hit(&node, &ahead()).unwrap();
        assert_abs_diff_eq!(found.t, 4.0, epsilon = 64.0 * f64::EPSILON);
    }
    let world = World::new(Color::BLACK).unwrap();
    let world = world.with(far(), Color::RED).with(near(), Color::GREEN);
    assert_eq!(world.color_for(&ahead()), Color::GREEN);
}

#[test]
fn the_nearest_child_is_seen_in_whatever_order_they_are_listed() {
    let sphere = |n: usize| {
        let z = [-3.0, -6.0, -10.0][n];
        Sphere::new(Point3::new(0.0, 0.0, z), 1.0).unwrap()
    };
    for order in [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ] {
        let empty = Node::new(scaled(2.0, 2.0, 2.0));
        let node = order
            .into_iter()
            .fold(empty, |node, n| node.with(sphere(n)));
        for (min, expected) in [(0.0, 4.0), (8.0, 10.0), (14.0, 18.0)] {
            let within = Interval { min, max: 20.0 };
            let found = node.hit(&ahead(), within).unwrap();
            assert_eq!(found, Hit::new(expected, (-AHEAD).as_normal()));
        }
        let (before, between) = (
            Interval::before(4.0),
            Interval {
                min: 14.0,
                max: 18.0,
            },
        );
        assert_eq!(node.hit(&ahead(), before), None);
        assert_eq!(node.hit(&ahead(), between), None);
    }
}

#[test]
fn a_node_without_children_is_nothing() {
    assert_eq!(hit(&Node::new(scaled(2.0, 3.0, 4.0)), &ahead()), None);
    let nested = Node::new(Transform::IDENTITY).with(Node::new(Transform::IDENTITY));
    assert_eq!(hit(&nested, &ahead()), None);
}

/// Bound: each of the hundred steps rounds twice, at 4 eps of the distance
/// over the cosine.
#[test]
fn a_deep_tree_is_the_product_of_its_transforms() {
    let (lbf, run) = (Point3::new(-2.0, -1.0, -1.5), Point3::new(1.0, 2.0, 1.5));
    let inside = AxisAlignedBox::new(lbf, run).unwrap();
    let step = |transform: Transform, n: u32| {
        let angle = 1.0 + 0.1 * f64::from(n % 10);
        let moved = transform
            .translate(Point3::new(0.01, -0.02, 0.005))
            .unwrap();
        match n % 3 {
            0 => moved.rotate_x(angle),
            1 => moved.rotate_y(angle),
            _ => moved.rotate_z(angle),
        }
        .unwrap()
    };
    let innermost = Node::new(Transform::IDENTITY).with(inside);
    let nested = (0..100).rev().fold(innermost, |node, n| {
        Node::new(step(Transform::IDENTITY, n)).with(node)
    });
    let flat = Node::new((0..100).fold(Transform::IDENTITY, step)).with(inside);
    let mut hits = 0;
    for ray in rays(2000) {
        let (nested, flat) = (hit(&nested, &ray), hit(&flat, &ray));
        assert_eq!(nested.is_some(), flat.is_some());
        let (Some(nested), Some(flat)) = (nested, flat) else {
            continue;
        };
        let cosine = flat.face.dot(ray.direction()).abs();
        let bound = 100.0 * 2.0 * 4.0 * f64::EPSILON * 10.0;
        assert_abs_diff_eq!(nested.t, flat.t, epsilon = bound / cosine);
        assert_abs_diff_eq!(nested.normal, flat.normal, epsilon = bound);
        hits += 1;
    }
    assert!(hits > 500, "{hits} hits");
}
