//! The bounds of nodes, and their parts: what a search goes by.
//!
//! Bounds that are too large change no picture, only the time it takes; so they
//! are tested by themselves.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Bounds, Geometry, Interval, Plane, Sphere};
use a07_transforms::{Node, Transform};

/// From -1 to 1 along each axis.
fn cube() -> AxisAlignedBox {
    AxisAlignedBox::new(Point3::new(-1.0, -1.0, -1.0), Point3::new(1.0, 1.0, 1.0)).unwrap()
}

fn translated(x: f64, y: f64, z: f64) -> Transform {
    let to = Point3::new(x, y, z);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.scale(x, y, z).unwrap()
}

/// The bounds hold the box, with room for the 4096 units of rounding that a hit
/// may be off; and with no more than a hundred times as much.
fn assert_fits(transform: Transform, min: [f64; 3], max: [f64; 3]) {
    let bounds = Node::new(transform).with(cube()).bounds();
    let largest = min.iter().chain(&max).fold(0.0, |a: f64, x| a.max(x.abs()));
    let room = 4096.0 * f64::EPSILON * largest;
    for axis in 0..3 {
        for beyond in [min[axis] - bounds.min[axis], bounds.max[axis] - max[axis]] {
            let fits = (room..100.0 * room).contains(&beyond);
            assert!(fits, "axis {axis}: {beyond:e} beyond, not {room:e}");
        }
    }
}

#[test]
fn bounds_are_moved_and_stretched_with_the_node() {
    assert_fits(Transform::IDENTITY, [-1.0; 3], [1.0; 3]);
    let moved = translated(10.0, -20.0, 30.0);
    assert_fits(moved, [9.0, -21.0, 29.0], [11.0, -19.0, 31.0]);
    let stretched = moved.scale(2.0, -3.0, 0.5).unwrap();
    assert_fits(stretched, [8.0, -23.0, 29.5], [12.0, -17.0, 30.5]);
    for size in [1e-50, 1e50] {
        assert_fits(scaled(size, size, size), [-size; 3], [size; 3]);
    }
}

/// On its edge a cube of half width 1 is √2 high, and on its corner √2 + √½ √2
/// wide: its extents are the sums of the rows' magnitudes.
#[test]
fn bounds_of_a_turned_cube_are_those_of_its_corners() {
    let root = 2_f64.sqrt();
    let turned = Transform::IDENTITY.rotate_z(FRAC_PI_4).unwrap();
    assert_fits(turned, [-root, -root, -1.0], [root, root, 1.0]);
    let twice = turned.rotate_x(FRAC_PI_4).unwrap();
    let across = root / 2.0 + 1.0;
    assert_fits(twice, [-across, -across, -root], [across, across, root]);
    let moved = translated(5.0, 0.0, 0.0).rotate_y(FRAC_PI_4).unwrap();
    assert_fits(moved, [5.0 - root, -1.0, -root], [5.0 + root, 1.0, root]);
}

/// Rounding moves what is hit by up to 2^20 units of what is stretched 2^20
/// times as far in one direction as in another; of more no bounds are sure.
#[test]
fn what_is_stretched_too_unequally_has_no_bounds() {
    let condition = |stretch: f64| {
        let node = Node::new(scaled(stretch, 1.0, 1.0)).with(cube());
        node.bounds()
    };
    assert!(condition(1_048_576.0).are_finite());
    assert_eq!(condition(1_048_577.0), Bounds::EVERYWHERE);
}

#[test]
fn what_holds_all_of_space_or_nothing_has_no_bounds() {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let moved = || Node::new(translated(1.0, 2.0, 3.0));
    for node in [
        moved(),
        moved().with(floor),
        moved().with(cube()).with(floor),
    ] {
        assert_eq!(node.bounds(), Bounds::EVERYWHERE);
    }
}

/// Each part is met where the child is, and only there; a node of one child has
/// no parts, but one of a node of two has.
#[test]
fn a_node_is_taken_apart_into_its_children() {
    let sphere = |x| Sphere::new(Point3::new(x, 0.0, 0.0), 1.0).unwrap();
    let moved = || Node::new(translated(0.0, 5.0, 0.0));
    assert!(moved().parts().is_none());
    assert!(moved().with(sphere(0.0)).parts().is_none());
    let two = || moved().with(sphere(-3.0)).with(sphere(3.0));
    for (node, y) in [(two(), 5.0), (moved().with(two()), 10.0)] {
        let parts = node.parts().unwrap();
        assert_eq!(parts.len(), 2);
        for (part, x) in parts.iter().zip([-3.0, 3.0]) {
            let hit = |x| {
                let ray = Ray::derived(Point3::new(x, y, 9.0), Vector3::new(0.0, 0.0, -1.0));
                part.hit(&ray, Interval::AHEAD).map(|hit| hit.t)
            };
            assert_eq!((hit(x), hit(-x)), (Some(8.0), None));
        }
    }
}
