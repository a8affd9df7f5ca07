//! Nodes: objects that are moved by moving the ray.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a05_lighting::{Lambert, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld};
use a07_transforms::{Node, Transform};
use approx::assert_abs_diff_eq;
use common::Color;

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn unit_sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

fn translated(x: f64, y: f64, z: f64) -> Transform {
    let to = Point3::new(x, y, z);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.scale(x, y, z).unwrap()
}

/// A unit sphere scaled by `r`, its front at z = `-distance`.
fn sphere_ahead(distance: f64, r: f64) -> Node {
    let transform = translated(0.0, 0.0, -distance - r);
    Node::new(transform.scale(r, r, r).unwrap()).with(unit_sphere())
}

fn ahead() -> Ray {
    Ray::new(Point3::ORIGIN, AHEAD).unwrap()
}

fn hit(geometry: &impl Geometry, ray: &Ray) -> Option<Hit> {
    geometry.hit(ray, Interval::AHEAD)
}

/// Rays from a distance of some 10 towards and past the origin.
fn rays(count: u32) -> impl Iterator<Item = Ray> {
    (0..count).map(|n| {
        let random = PixelRandom::new(17, n, 0);
        let vector = |first: u64, width: f64| {
            let three = [0, 1, 2].map(|i| width * (random.uniform(first + i) - 0.5));
            Vector3::from_glam(three.into())
        };
        let out = vector(0, 1.0).normalized().unwrap();
        let eye = Point3::ORIGIN + out * 10.0;
        let aim = Point3::ORIGIN + vector(3, 8.0);
        Ray::new(eye, aim - eye).unwrap()
    })
}

/// The same hits and misses. Bound: that of each shape, 4 eps of the distance
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

/// Lit from outside, no place of a stretched and turned shape shades itself.
/// Tolerance: the cosine is calculated twice.
#[test]
fn transformed_shapes_do_not_shade_themselves() {
    for s in [1e-6, 1.0, 1e9] {
        let transform = translated(3.0 * s, -2.0 * s, 5.0 * s)
            .rotate_x(0.4)
            .and_then(|transform| transform.rotate_z(-0.7))
            .and_then(|transform| transform.scale(3.0 * s, 0.6 * s, 2.0 * s))
            .unwrap();
        let middle = transform.matrix() * Point3::ORIGIN;
        let light = middle + Vector3::new(1.0, 8.0, 3.0) * s;
        let cube = AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        for node in [
            Node::new(transform).with(unit_sphere()),
            Node::new(transform).with(cube.unwrap()),
        ] {
            let white = Lambert::new(Color::WHITE).unwrap();
            let lamp = PointLight::new(Color::WHITE, light).unwrap();
            let world = ShadowedWorld::empty(Color::BLACK, Color::BLACK)
                .unwrap()
                .with(node, Box::new(white))
                .lit_by(LightSource::new(lamp, true));
            let tracer = RecursiveTracer::new(&world);
            let mut lit = 0;
            for n in 0..8000 {
                let random = PixelRandom::new(18, n, 0);
                let aim = [0, 1, 2].map(|i| (4.0 * random.uniform(i) - 2.0) * s);
                let eye = middle + Vector3::new(-6.0, 5.0, -4.0) * s;
                let aim = middle + Vector3::from_glam(aim.into());
                let ray = Ray::new(eye, aim - eye).unwrap();
                let Some((found, _)) = world.objects().hit(&ray, Interval::AHEAD) else {
                    continue;
                };
                let l = (light - ray.at(found.t)).normalized().unwrap();
                let n_l = found.normal.dot(l);
                if n_l > 1e-3 {
                    assert_abs_diff_eq!(tracer.trace(&ray, 1).r, n_l, epsilon = 4.0 * f64::EPSILON);
                    lit += 1;
                }
            }
            assert!(lit > 300, "{lit} places are tested");
        }
    }
}
