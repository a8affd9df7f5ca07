//! Laws of every shape and every ray, wherever they are.
//!
//! The same cases come every time; `PROPTEST_CASES=100000` makes more of them.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle, World};
use common::Color;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const EPS: f64 = f64::EPSILON;

fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    ProptestConfig {
        // A failure is printed, and comes again without a file that tells of it.
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        cases: default.cases.max(1000),
        ..default
    }
}

/// Half of them from -16 to 16, and half from -1 to 1 in eighths, so that rays
/// go along axes, through edges and through corners.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![-16.0..16.0, (-8..=8).prop_map(|n| f64::from(n) / 8.0)]
}

fn vector() -> impl Strategy<Value = Vector3> {
    prop::array::uniform3(coordinate()).prop_map(|[x, y, z]| Vector3::new(x, y, z))
}

fn point() -> impl Strategy<Value = Point3> {
    vector().prop_map(|way| Point3::ORIGIN + way)
}

type Shape = Box<dyn Geometry>;

fn plane() -> impl Strategy<Value = Shape> {
    let planes = (point(), vector()).prop_map(|(a, n)| Plane::new(a, n.as_normal()));
    planes.prop_filter_map("a direction", |plane| Some(Box::new(plane.ok()?) as _))
}

fn sphere() -> impl Strategy<Value = Shape> {
    let spheres = (point(), 0.01..8.0).prop_map(|(c, r)| Sphere::new(c, r));
    spheres.prop_map(|sphere| Box::new(sphere.unwrap()) as _)
}

fn aligned_box() -> impl Strategy<Value = Shape> {
    let boxes = (point(), point()).prop_map(|(lbf, run)| AxisAlignedBox::new(lbf, run));
    boxes.prop_map(|aligned| Box::new(aligned.unwrap()) as _)
}

fn corners() -> impl Strategy<Value = [Point3; 3]> {
    prop::array::uniform3(point())
}

fn triangle() -> impl Strategy<Value = Shape> {
    let triangles = corners().prop_map(|[a, b, c]| Triangle::new(a, b, c));
    triangles.prop_filter_map("not on a line", |triangle| {
        Some(Box::new(triangle.ok()?) as _)
    })
}

fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![plane(), sphere(), aligned_box(), triangle()]
}

/// From one point towards another.
fn ray() -> impl Strategy<Value = Ray> {
    let rays = (point(), point()).prop_map(|(from, to)| Ray::new(from, to - from));
    rays.prop_filter_map("two points", Result::ok)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn nothing_lies_before_the_nearest_hit(shape in shape(), ray in ray()) {
        if let Some(hit) = shape.hit(&ray, Interval::AHEAD) {
            prop_assert!(hit.t > 0.0);
            prop_assert_eq!(shape.hit(&ray, Interval::before(hit.t)), None);
            let just_beyond = Interval::before(hit.t.next_up());
            prop_assert_eq!(shape.hit(&ray, just_beyond), Some(hit));
        }
    }

    /// Of the way from the plane, the distance of the origin is off by 4u of
    /// |a - o|, the step of a ray by 3u of t, the quotient by u, and the point by
    /// u of t and of |p|; to compute the way takes 4u of |p - a|. Together less
    /// than 10u, 5 eps, of |a - o| + t + |o|.
    #[test]
    fn a_hit_of_a_plane_lies_in_it(a in point(), n in vector(), ray in ray()) {
        let n = n.as_normal();
        prop_assume!(n.normalized().is_some());
        if let Some(hit) = Plane::new(a, n).unwrap().hit(&ray, Interval::AHEAD) {
            let (o, p) = (ray.origin(), ray.at(hit.t));
            let lengths = (a - o).magnitude() + hit.t + (o - Point3::ORIGIN).magnitude();
            prop_assert!((p - a).dot(hit.normal).abs() <= 5.0 * EPS * lengths);
        }
    }

    /// Steiner's power of a point: the product of the two distances is f · f - r²
    /// for every direction. This is off by 6u of its terms, two roots and a
    /// product by 4u, and the length of the direction by 4u, twice.
    #[test]
    fn the_two_hits_of_a_sphere_have_the_power_of_the_origin(
        c in point(), r in 0.01..8.0, ray in ray(),
    ) {
        let sphere = Sphere::new(c, r).unwrap();
        let after = |min| sphere.hit(&ray, Interval { min, max: f64::INFINITY });
        if let Some(first) = after(f64::NEG_INFINITY) && let Some(second) = after(first.t) {
            let f = ray.origin() - c;
            let off = first.t * second.t - (f.dot(f) - r * r);
            prop_assert!(off.abs() <= 10.0 * EPS * (f.dot(f) + r * r));
        }
    }

    /// Of shapes at the same place, the first of the list counts.
    #[test]
    fn a_world_is_hit_where_the_nearest_of_its_shapes_is(
        shapes in prop::collection::vec(shape(), 0..8), ray in ray(), max in 0.0..64.0,
    ) {
        let within = Interval::before(max);
        let hits = shapes.iter().map(|shape| shape.hit(&ray, within));
        let hits = (0..).zip(hits).filter_map(|(turn, hit)| Some((hit?.t, turn)));
        let nearest = hits.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut world = World::new(Color::BLACK).unwrap();
        for (turn, shape) in (0..).zip(shapes) {
            world = world.with(shape, turn);
        }
        let met = world.hit(&ray, within).map(|(hit, turn)| (hit.t, *turn));
        prop_assert_eq!(met, nearest);
        prop_assert_eq!(world.is_hit(&ray, within), nearest.is_some());
    }
}
