//! Rays that just touch, shapes at the same place, and shapes that rounding makes
//! points.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::fast::shapes;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Sphere, Triangle, World};
use common::Color;

use super::compare::compare;
use crate::support::{Numbers, eighths};

/// A world of these shapes.
fn list<G: Geometry + Clone>(shapes: &[G]) -> World<usize> {
    let empty = World::new(Color::BLACK).unwrap();
    let shapes = shapes.iter().cloned().enumerate();
    shapes.fold(empty, |world, (i, shape)| world.with(shape, i))
}

/// From a point to a point.
fn towards(from: Point3, to: Point3) -> Ray {
    Ray::new(from, to - from).unwrap()
}

/// A list of this many.
fn many<T>(count: usize, make: impl FnMut() -> T) -> Vec<T> {
    std::iter::repeat_with(make).take(count).collect()
}

/// The number of rays that hit one of these shapes, as the engine and the list agree.
fn hits<G: Geometry + Clone>(these: &[G], rays: &[Ray]) -> usize {
    compare(&list(these), shapes, rays)
}

#[test]
fn rays_that_just_touch_are_decided_as_in_the_list() {
    let mut numbers = Numbers::new(7);
    let spheres = many(200, || {
        let c = Point3::ORIGIN + numbers.vector();
        (c, 0.05 * (1.1 + numbers.next()))
    });
    let eye = Point3::new(4.0, 3.0, 5.0);
    let mut rays = Vec::new();
    for (c, r) in &spheres {
        for _ in 0..40 {
            // To a point of the sphere where the ray is at a right angle to the
            // radius, up to rounding, from the eye and from elsewhere.
            for from in [eye, Point3::ORIGIN + numbers.vector() * 3.0] {
                let way = *c - from;
                let nearer = r * r / way.magnitude();
                let along = way.normalized().unwrap() * nearer;
                let aside = way.cross(numbers.vector()).normalized().unwrap();
                let aside = aside * (r * r - nearer * nearer).sqrt();
                rays.push(towards(from, *c - along + aside));
            }
        }
    }
    let spheres = spheres.into_iter().map(|(c, r)| Sphere::new(c, r).unwrap());
    let hits = hits(&spheres.collect::<Vec<_>>(), &rays);
    // About half of the rays pass on the inner side.
    assert!((rays.len() / 4..rays.len()).contains(&hits), "{hits}");
}

/// Far from the origin coordinates are multiples of 2^-9: the spheres are a few dozen of
/// these units wide, and rays towards their rims tell bounds apart that are half a unit
/// too small.
#[test]
fn spheres_a_few_units_of_rounding_wide_are_met_as_in_the_list() {
    let (far, unit) = (1e13, 1.0 / 512.0);
    let mut numbers = Numbers::new(17);
    let mut point = |reach: f64| {
        let [x, y, z] = [0; 3].map(|_| (numbers.next() * reach).round() * unit);
        Point3::new(far + x, y - far, far + z)
    };
    let mut met = 0;
    for n in 0..200 {
        let radius = |i: i32| (5.0 + f64::from((7 * n + i) % 20) / 3.0) * unit;
        let spheres = (0..12).map(|i| Sphere::new(point(40.0), radius(i)).unwrap());
        let spheres: Vec<_> = spheres.collect();
        let rays = many(400, || towards(point(200.0), point(50.0)));
        met += hits(&spheres, &rays);
    }
    assert!((8_000..80_000).contains(&met), "{met}");
}

/// The engine rejects rays beside a sphere before it computes their hits.
#[test]
fn rays_that_pass_a_sphere_by_next_to_nothing_are_decided_as_in_the_list() {
    let mut numbers = Numbers::new(8);
    let (mut met, mut all) = (0, 0);
    for size in [1e-95, 1e-6, 1.0, 1e95] {
        for i in 0..2_400 {
            let (c, r) = (numbers.vector(), 0.55 + 0.5 * numbers.next());
            let from = c + numbers.vector() * 4.0;
            let aside = (c - from).cross(numbers.vector()).normalized().unwrap();
            // Beside the sphere by this share of the radius; or from its surface outwards,
            // inwards or along it.
            let off = [0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-3][i / 3 % 8];
            let (from, to) = match i % 3 {
                0 => (from, c + aside * (r * (1.0 + off * numbers.next())) - from),
                1 => (c + aside * (r * (1.0 + off)), numbers.vector()),
                _ => (c + aside * r, aside.cross(numbers.vector())),
            };
            let at = |v: Vector3| Point3::ORIGIN + v * size;
            let sphere = Sphere::new(at(c), r * size).unwrap();
            let ray = Ray::new(at(from), to).unwrap();
            let other = Ray::derived(ray.origin(), ray.direction() * (1.0 + numbers.next()));
            met += hits(&[sphere], &[ray, other]);
            all += 2;
        }
    }
    assert!((all / 4..3 * all / 4).contains(&met), "{met} of {all}");
}

/// By rounding, these rays leave a box before they enter it.
#[test]
fn rays_through_edges_are_decided_as_in_the_list() {
    let mut numbers = Numbers::new(8);
    let corners = [(); 5].map(|()| Point3::ORIGIN + numbers.vector());
    let size = Vector3::new(0.3, 0.2, 0.1);
    let boxes = corners.map(|corner| AxisAlignedBox::new(corner, corner + size).unwrap());
    let eye = Point3::new(4.0, 3.0, 5.0);
    let mut rays = Vec::new();
    for i in 0..4000 {
        // An edge that can be seen from where all rays come from.
        let along = 0.5 + 0.4 * numbers.next();
        let (x, y) = [(0.3, along * 0.2), (along * 0.3, 0.2)][i % 2];
        let edge = corners[i % 5] + Vector3::new(x, y, [0.1, 0.0][i / 2 % 2]);
        let aside = numbers.vector();
        let from = Point3::new(aside.x() + 3.0, aside.y() + 3.0, aside.z());
        rays.extend([towards(eye, edge), towards(from, edge)]);
    }
    assert!(hits(&boxes, &rays) > 1000);
}

/// From so far away its corners are one point but for rounding, in any unit.
#[test]
fn triangles_far_beside_rays_are_met_by_none() {
    let mut numbers = Numbers::new(9);
    for scale in [1.0, 1.0 / (1_u64 << 60) as f64] {
        let corners = [[0.0, 1.5, 3.0], [10.0, 0.0, 8.5], [1.0, 0.0, 0.0]];
        let [a, b, c] = corners.map(|corner| Point3::from_glam(corner.map(|x| x * scale).into()));
        let far = 9_007_199_254_740_992.0 * scale;
        let rays = many(40_000, || {
            let from = Point3::ORIGIN + numbers.vector() * far;
            Ray::new(from, numbers.vector()).unwrap()
        });
        hits(&[Triangle::new(a, b, c).unwrap()], &rays);
    }
}

/// From so far away that the radius is below rounding, a sphere has no normal.
#[test]
fn a_sphere_rounded_to_a_point_is_decided_as_in_the_list() {
    let centre = Point3::new(0.5, 0.25, 0.75);
    let eye = Point3::new(0.5, 0.25, 1e20);
    let mut numbers = Numbers::new(11);
    let mut rays = vec![towards(eye, centre); 40];
    for far in [1e14, 1e15, 1e16, 1e17, 1e18, 1e20] {
        rays.extend(many(200, || {
            towards(centre + numbers.vector() * far, centre)
        }));
    }
    let hits = hits(&[Sphere::new(centre, 1.0).unwrap()], &rays);
    assert!((200..rays.len()).contains(&hits), "{hits}");
}

/// The normals of two corners are opposite: half way between them is none.
#[test]
fn normals_that_cancel_are_decided_as_in_the_list() {
    let corner = |x, y| Point3::new(x, y, 0.0);
    let [up, down] = [1.0, -1.0].map(|z| Normal3::new(0.0, 0.0, z));
    let flat = Triangle::new(corner(0.0, 0.0), corner(4.0, 0.0), corner(0.0, 4.0)).unwrap();
    let smooth = flat.with_normals([up, down, up]).unwrap();
    let rays = (0..400).map(|i| {
        let y = f64::from(i % 8) / 4.0;
        let x = [2.0, f64::from(i) / 200.0][usize::from(i % 4 == 1)];
        towards(Point3::new(x, y, 8.0), corner(x, y))
    });
    assert_eq!(hits(&[smooth], &rays.collect::<Vec<_>>()), 400);
}

/// Cuts by area alone take only a few of them off at each level.
#[test]
fn spheres_of_all_sizes_are_met_as_in_the_list() {
    let sphere = |exponent: i32| {
        let size = libm::ldexp(1.0, exponent);
        Sphere::new(Point3::new(size, 0.0, 0.0), size / 4.0).unwrap()
    };
    let spheres: Vec<_> = (-300..=300).map(sphere).collect();
    let ray = |exponent: i32| {
        let (from, to) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let before = libm::ldexp(1.0, exponent);
        match exponent % 3 {
            0 => towards(Point3::new(-before, 0.0, 0.0), from),
            1 => towards(Point3::new(2.0 * before, before, 0.0), to),
            _ => towards(Point3::new(before * 1.5, 0.0, 0.0), from),
        }
    };
    let rays: Vec<_> = (-300..=300).map(ray).collect();
    assert!(hits(&spheres, &rays) > 400);
}

/// The upper faces of both boxes lie in one plane. The larger one comes nearer to the
/// eye and is tested first, wherever it stands in the list.
#[test]
fn of_two_at_the_same_place_the_first_of_the_list_counts() {
    let aab = |half: f64| {
        let low = Point3::new(-half, -half, -1.0);
        AxisAlignedBox::new(low, Point3::new(half, half, 0.0)).unwrap()
    };
    let eye = Point3::new(5.0, 0.5, 3.0);
    let mut numbers = Numbers::new(13);
    let mut aim = || Point3::new(numbers.next(), numbers.next(), 0.0);
    let rays = many(400, || towards(eye, aim()));
    for boxes in [[aab(1.0), aab(2.0)], [aab(2.0), aab(1.0)]] {
        assert_eq!(hits(&boxes, &rays), 400);
        let world = list(&boxes);
        let first = |ray: &Ray| *world.hit(ray, Interval::AHEAD).unwrap().1 == 0;
        assert!(rays.iter().all(first));
    }
}

/// Rounding alone decides whether and where these rays hit, also outside of the bounds of
/// a triangle. With more than sixteen triangles the engine builds a tree.
#[test]
fn rays_in_the_plane_of_a_triangle_are_decided_as_in_the_list() {
    let (mut met, mut all) = (0, 0);
    for seed in 0..400 {
        let random = PixelRandom::new(seed, 0, 0);
        let (mut triangles, mut rays) = (Vec::new(), Vec::new());
        for i in 0..20 {
            let [a, b, c] = [0, 3, 6].map(|n| eighths(random, 9 * i + n));
            let Ok(triangle) = Triangle::new(a, b, c) else {
                continue;
            };
            triangles.push(triangle);
            // From a point of the plane beside the triangle to points around its middle.
            let at = |beta: f64, gamma: f64| a + (b - a) * beta + (c - a) * gamma;
            for beta in [0.125, 0.25, 1.0 / 3.0, 0.5] {
                let aims = [0.125, 0.25, 1.0 / 3.0, 0.5].map(|gamma| at(beta, gamma));
                rays.extend(aims.map(|aim| towards(at(2.5, 1.25), aim)));
            }
        }
        met += hits(&triangles, &rays);
        all += rays.len();
    }
    assert!((all / 10..all).contains(&met), "{met} of {all}");
}
