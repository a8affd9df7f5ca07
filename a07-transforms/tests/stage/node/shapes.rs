//! A transformed shape is the shape that lies there.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a07_transforms::{Node, Transform};
use approx::assert_abs_diff_eq;
use common::Color;

use super::{AHEAD, ahead, hit, rays, scaled, translated, unit_sphere};

/// The same hits and misses. Bound: the error of each shape, 4 eps of the distance
/// over the cosine, twice, as both are rounded, and as much again for the
/// transform; in units of the smallest shape for the normals.
fn assert_same(one: &impl Geometry, other: &impl Geometry) {
    let mut hits = 0;
    for ray in rays(3000) {
        let (one, other) = (hit(one, &ray), hit(other, &ray));
        assert_eq!(one.is_some(), other.is_some(), "{ray:?}");
        let (Some(one), Some(other)) = (one, other) else {
            continue;
        };
        let cosine = one.face.dot(ray.direction()).abs();
        let bound = 16.0 * f64::EPSILON * 20.0 / cosine;
        assert_abs_diff_eq!(one.t, other.t, epsilon = bound);
        assert_abs_diff_eq!(one.normal, other.normal, epsilon = bound);
        assert_abs_diff_eq!(one.face, other.face, epsilon = bound);
        hits += 1;
    }
    assert!(hits > 300, "{hits} hits");
}

#[test]
fn what_is_not_transformed_stays_as_it_is() {
    let sphere = Sphere::new(Point3::new(0.5, -0.25, 1.0), 2.0).unwrap();
    let node = Node::new(Transform::IDENTITY).with(sphere);
    for ray in rays(1000) {
        let [same, sphere] = [hit(&node, &ray), hit(&sphere, &ray)];
        assert_eq!(same.map(|hit| hit.t), sphere.map(|hit| hit.t));
        if let (Some(same), Some(sphere)) = (same, sphere) {
            // Its length was rounded a second time.
            assert_abs_diff_eq!(same.normal, sphere.normal, epsilon = f64::EPSILON);
        }
    }
}

#[test]
fn a_transformed_shape_is_the_shape_that_lies_there() {
    let transform = translated(0.5, -0.25, 1.0).scale(2.0, 2.0, 2.0).unwrap();
    let sphere = Sphere::new(Point3::new(0.5, -0.25, 1.0), 2.0).unwrap();
    assert_same(&Node::new(transform).with(unit_sphere()), &sphere);

    let (transform, half) = (translated(0.5, -0.25, 1.0), Point3::new(0.5, 0.5, 0.5));
    let cube = AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), half).unwrap();
    let stretched = Node::new(transform.scale(3.0, -2.0, 4.0).unwrap()).with(cube);
    let (lbf, run) = (Point3::new(-1.0, -1.25, -1.0), Point3::new(2.0, 0.75, 3.0));
    assert_same(&stretched, &AxisAlignedBox::new(lbf, run).unwrap());

    let floor = Plane::new(Point3::ORIGIN, Vector3::new(0.0, 1.0, 0.0).as_normal()).unwrap();
    // A quarter turn about z moves the normal from y to -x.
    let turned = Node::new(transform.rotate_z(FRAC_PI_2).unwrap()).with(floor);
    let wall = Vector3::new(-1.0, 0.0, 0.0).as_normal();
    assert_same(
        &turned,
        &Plane::new(Point3::new(0.5, 0.0, 0.0), wall).unwrap(),
    );

    let corners = [[-2.0, 0.0, 0.5], [1.0, -1.0, -1.0], [0.0, 2.0, 1.0]];
    let triangle = |of: &dyn Fn(Point3) -> Point3| {
        let [a, b, c] = corners.map(|p| of(Point3::from_glam(p.into())));
        Triangle::new(a, b, c).unwrap()
    };
    let transform = translated(0.5, -0.5, 0.25).rotate_y(0.7).unwrap();
    let m = transform.scale(1.5, 2.0, 0.75).unwrap();
    let moved = triangle(&|p| m.matrix() * p);
    assert_same(&Node::new(m).with(triangle(&|p| p)), &moved);
}

/// On the ellipsoid of half axes (6, 1.2, 4), a ray through the middle ends at
/// the distance 1 / sqrt(Σ (d / half axis)²) from it, and the normal is as p
/// over the squares of the half axes.
#[test]
fn a_stretched_sphere_is_an_ellipsoid() {
    let axes = [6.0, 1.2, 4.0];
    let [x, y, z] = axes;
    let ellipsoid = Node::new(scaled(x, y, z)).with(unit_sphere());
    for ray in rays(500) {
        let d = (Point3::ORIGIN - ray.origin()).normalized().unwrap();
        let ray = Ray::new(ray.origin(), d).unwrap();
        let d = d.to_glam().to_array();
        let [a, b, c]: [f64; 3] = std::array::from_fn(|i| d[i] / axes[i]);
        let expected = 10.0 - 1.0 / (a * a + b * b + c * c).sqrt();
        let found = hit(&ellipsoid, &ray).unwrap();
        let (p, n) = (ray.at(found.t).to_glam().to_array(), found.normal);
        let outwards = std::array::from_fn(|i| p[i] / (axes[i] * axes[i]));
        let normal = Vector3::from_glam(outwards.into()).normalized().unwrap();
        // Seen from the object the eye is 10 / 1.2 away, and no normal leans
        // more than 6 / 1.2 over: bound 4 eps 10 · 5².
        let bound = 4.0 * f64::EPSILON * 250.0;
        assert_abs_diff_eq!(found.t, expected, epsilon = bound);
        assert_abs_diff_eq!(n, normal.as_normal(), epsilon = bound);
        assert_eq!(found.face, n);
    }
}

/// The cosine of a quarter turn is 6e-17, so that rays along the axes of the
/// world run almost, but not quite, within the faces of the box.
#[test]
fn a_turned_box_is_met_along_its_faces_and_edges() {
    let cube = AxisAlignedBox::new(Point3::ORIGIN, Point3::new(1.0, 1.0, 1.0)).unwrap();
    let turned = Node::new(Transform::IDENTITY.rotate_z(FRAC_PI_2).unwrap()).with(cube);
    // x of the cube becomes y, and y becomes -x.
    for y in [0.0, 0.25, 1.0] {
        for z in [0.0, 0.5, 1.0] {
            let ray = Ray::derived(Point3::new(4.0, y, z), Vector3::new(-1.0, 0.0, 0.0));
            if (y, z) == (0.25, 0.5) {
                let found = hit(&turned, &ray).unwrap();
                assert_abs_diff_eq!(found.t, 4.0, epsilon = 8.0 * f64::EPSILON);
                let normal = Vector3::new(1.0, 0.0, 0.0).as_normal();
                assert_abs_diff_eq!(found.normal, normal, epsilon = f64::EPSILON);
            }
            let inwards = Ray::derived(Point3::new(-0.5, 0.5, 0.5), ray.direction());
            assert_abs_diff_eq!(hit(&turned, &inwards).unwrap().t, 0.5, epsilon = 1e-15);
        }
    }
}

#[test]
fn mirrored_objects_face_outwards_and_towards_the_eye() {
    let node = || Node::new(scaled(-2.0, 1.0, 1.0)).with(unit_sphere());
    let right = Vector3::new(1.0, 0.0, 0.0);
    let from_outside = Ray::new(Point3::new(5.0, 0.0, 0.0), -right).unwrap();
    let found = hit(&node(), &from_outside).unwrap();
    assert_eq!(found, Hit::new(3.0, right.as_normal()));
    let from_inside = Ray::new(Point3::ORIGIN, right).unwrap();
    let found = hit(&node(), &from_inside).unwrap();
    assert_eq!(found, Hit::new(2.0, right.as_normal()));
    let world = World::new(Color::BLACK).unwrap().with(node(), ());
    let (seen, ()) = world.hit(&from_inside, Interval::AHEAD).unwrap();
    assert_eq!(seen.normal, -right.as_normal());
}

/// Radii at both ends of the allowed range, brought to 1.
#[test]
fn extreme_shapes_can_be_brought_to_a_common_size() {
    for r in [1e-100, 1e-50, 1e50, 1e100] {
        let sphere = Sphere::new(Point3::ORIGIN, r).unwrap();
        let transform = translated(0.0, 0.0, -3.0).scale(1.0 / r, 1.0 / r, 1.0 / r);
        let node = Node::new(transform.unwrap()).with(sphere);
        let found = hit(&node, &ahead()).unwrap();
        assert_abs_diff_eq!(found.t, 2.0, epsilon = 32.0 * f64::EPSILON);
        assert_eq!(found.normal, (-AHEAD).as_normal());
        let beside = Ray::derived(Point3::new(1.001, 0.0, 0.0), AHEAD);
        assert_eq!(hit(&node, &beside), None);
    }
}
