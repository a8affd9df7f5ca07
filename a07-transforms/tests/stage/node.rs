//! Nodes: a transformed shape is the shape that lies there. Ellipsoids, and points that
//! must not shade themselves, are the extreme cases G14, G29 and G30.

use std::f64::consts::FRAC_PI_2;

use a02_math::arrays::{point, vector};
use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a07_transforms::{Node, Transform};
use approx::assert_abs_diff_eq;
use testing::Random;

/// A ray whose direction keeps its length.
fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(point(o), vector(d))
}

/// The nearest hit of a shape ahead of the ray's origin.
fn hit(shape: &dyn Geometry, ray: &Ray) -> Option<Hit> {
    shape.hit(ray, Interval::AHEAD)
}

/// A vector of three random numbers from `-width` to `width`.
fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

fn unit_sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

fn cube() -> AxisAlignedBox {
    AxisAlignedBox::new(point([-0.5; 3]), point([0.5; 3])).unwrap()
}

fn translated(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.translate(Point3::new(x, y, z)).unwrap()
}

/// Rays from a distance of 10 towards and past the origin.
fn rays() -> impl Iterator<Item = Ray> {
    (0..3000).map(|n| {
        let random = PixelRandom::new(17, n, 0);
        let out = random_vector(random, 0, 0.5).normalized().unwrap();
        let eye = Point3::ORIGIN + out * 10.0;
        Ray::new(eye, random_vector(random, 3, 4.0) - out * 10.0).unwrap()
    })
}

/// The same hits and misses. Bound: the error of each shape, 4 eps of the distance
/// over the cosine, twice, as both are rounded, and as much again for the
/// transform; in units of the smallest shape for the normals.
fn assert_same(one: &dyn Geometry, other: &dyn Geometry) {
    let mut hits = 0;
    for ray in rays() {
        let (one, other) = (hit(one, &ray), hit(other, &ray));
        assert_eq!(one.is_some(), other.is_some(), "{ray:?}");
        let (Some(one), Some(other)) = (one, other) else {
            continue;
        };
        let cosine = one.geometric_normal.dot(ray.direction()).abs();
        let bound = 16.0 * f64::EPSILON * 20.0 / cosine;
        assert_abs_diff_eq!(one.t, other.t, epsilon = bound);
        assert_abs_diff_eq!(one.normal, other.normal, epsilon = bound);
        assert_abs_diff_eq!(
            one.geometric_normal,
            other.geometric_normal,
            epsilon = bound
        );
        hits += 1;
    }
    assert!(hits > 300, "{hits} hits");
}

#[test]
fn a_transformed_shape_is_the_shape_that_lies_there() {
    let place = translated(0.5, -0.25, 1.0);
    let sphere = Sphere::new(Point3::new(0.5, -0.25, 1.0), 2.0).unwrap();
    let doubled = place.scale(2.0, 2.0, 2.0).unwrap();
    assert_same(&Node::new(doubled).with(unit_sphere()), &sphere);

    // One factor mirrors.
    let stretched = Node::new(place.scale(3.0, -2.0, 4.0).unwrap()).with(cube());
    let (lbf, run) = (Point3::new(-1.0, -1.25, -1.0), Point3::new(2.0, 0.75, 3.0));
    assert_same(&stretched, &AxisAlignedBox::new(lbf, run).unwrap());

    // A quarter turn about z moves the normal from y to -x.
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let turned = Node::new(place.rotate_z(FRAC_PI_2).unwrap()).with(floor);
    let wall = Plane::new(Point3::new(0.5, 0.0, 0.0), Normal3::new(-1.0, 0.0, 0.0));
    assert_same(&turned, &wall.unwrap());

    let turned = place
        .rotate_y(0.7)
        .and_then(|turned| turned.scale(1.5, 2.0, 0.75));
    let corners = [[-2.0, 0.0, 0.5], [1.0, -1.0, -1.0], [0.0, 2.0, 1.0]];
    let triangle = |transform: Transform| {
        let [a, b, c] = corners.map(|corner| transform.matrix() * point(corner));
        Triangle::new(a, b, c).unwrap()
    };
    let node = Node::new(turned.clone().unwrap()).with(triangle(Transform::IDENTITY));
    assert_same(&node, &triangle(turned.unwrap()));
}

/// Radii at both ends of the allowed range, brought to 1.
#[test]
fn extreme_shapes_can_be_brought_to_a_common_size() {
    for r in [1e-100, 1e-50, 1e50, 1e100] {
        let sphere = Sphere::new(Point3::ORIGIN, r).unwrap();
        let transform = translated(0.0, 0.0, -3.0).scale(1.0 / r, 1.0 / r, 1.0 / r);
        let node = Node::new(transform.unwrap()).with(sphere);
        let ahead = |x| hit(&node, &ray([x, 0.0, 0.0], [0.0, 0.0, -1.0]));
        let found = ahead(0.0).unwrap();
        assert_abs_diff_eq!(found.t, 2.0, epsilon = 32.0 * f64::EPSILON);
        assert_eq!(found.normal, Normal3::new(0.0, 0.0, 1.0));
        assert_eq!(ahead(1.001), None);
    }
}

/// Each child stands twice in the list, and in a space of its own, where distances in
/// lengths differ. The interval bounds the search, so that a child before it hides nothing.
#[test]
fn the_nearest_child_is_hit_in_any_order() {
    let mut hits = 0;
    for n in 0..2000 {
        let random = &mut Random::new(n);
        let (from, to) = (random.triple(8.0), random.triple(2.0));
        let ray = Ray::new(point(from), point(to) - point(from)).unwrap();
        let min = random.between(0.0, 4.0);
        let within = Interval {
            min,
            max: min + random.between(0.0, 24.0),
        };
        let count = n as usize % 8;
        let spheres = (0..count).map(|_| (point(random.triple(2.0)), random.between(0.1, 1.1)));
        let spheres: Vec<_> = spheres.collect();
        let child = |turn: usize| {
            let (center, radius) = spheres[turn % count.div_ceil(2)];
            let size = 1.0 + (turn % 3) as f64;
            let transform = Transform::IDENTITY.rotate_x(size).unwrap();
            let sphere = Sphere::new(center, radius).unwrap();
            Node::new(transform.scale(size, 1.0, size).unwrap()).with(sphere)
        };
        let alone = |turn| Node::new(Transform::IDENTITY).with(child(turn));
        let found = (0..count).filter_map(|turn| alone(turn).hit(&ray, within));
        let nearest = found.min_by(|a, b| a.t.total_cmp(&b.t));
        let all = Node::new(Transform::IDENTITY);
        let all = (0..count).fold(all, |node, turn| node.with(child(turn)));
        assert_eq!(all.hit(&ray, within), nearest);
        hits += u32::from(nearest.is_some());
    }
    assert!((300..1700).contains(&hits), "{hits} hits");
}

/// A sphere of radius 2 around (1, 0, 0), touched by rays at their own origins.
#[test]
fn a_ray_touches_a_transformed_sphere_at_its_origin() {
    let doubled = translated(1.0, 0.0, 0.0).scale(2.0, 2.0, 2.0).unwrap();
    let node = Node::new(doubled).with(unit_sphere());
    for d in [[0.0, 0.0, 1.0], [0.0, -3.0, 4.0]] {
        let tangent = ray([3.0, 0.0, 0.0], d);
        assert_eq!(node.hit(&tangent, Interval::AHEAD), None);
        let around = Interval {
            min: -1.0,
            max: 1.0,
        };
        let hit = node.hit(&tangent, around).unwrap();
        assert_eq!((hit.t, hit.normal), (0.0, Normal3::new(1.0, 0.0, 0.0)));
    }
}
