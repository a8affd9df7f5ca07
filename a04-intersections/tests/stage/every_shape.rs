//! Laws of every shape: open intervals, the ends of the allowed range, rays of no
//! numbers, and arguments that are refused. That scale and place of a scene change no bit
//! are the extreme cases S12 and I11.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle};
use approx::assert_relative_eq;
use testing::assert_refused;

use super::support::{hit, point, random_ray, random_shape, ray};

const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);

/// Shapes whose front is at z = `size`.
fn shapes(size: f64) -> [Box<dyn Geometry>; 4] {
    let at = |x: f64, y: f64, z: f64| point([x, y, z].map(|x| x * size));
    let [a, b, c] = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)].map(|(x, y)| at(x, y, 1.0));
    [
        Box::new(Plane::new(a, Z).unwrap()),
        Box::new(Sphere::new(Point3::ORIGIN, size).unwrap()),
        Box::new(AxisAlignedBox::new(at(-1.0, -1.0, -1.0), at(1.0, 1.0, 1.0)).unwrap()),
        Box::new(Triangle::new(a, b, c).unwrap()),
    ]
}

#[test]
fn the_ends_of_an_interval_do_not_belong_to_it() {
    let mut second_hits = 0;
    for n in 0..8000 {
        let (shape, ray) = (random_shape(n / 8), random_ray(n));
        let Some(first) = hit(&*shape, &ray) else {
            continue;
        };
        let within = |min, max| shape.hit(&ray, Interval { min, max });
        let t = first.t;
        assert_eq!(within(0.0, t), None, "{shape:?} {ray:?}");
        assert_eq!(within(t.next_down(), t.next_up()), Some(first));
        assert_eq!(within(t.next_up(), t.next_down()), None);
        if let Some(second) = within(t, f64::INFINITY) {
            assert!(t < second.t);
            assert_eq!(within(t, second.t), None);
            second_hits += 1;
        }
    }
    assert!(second_hits > 500, "{second_hits} rays leave a shape");
}

/// Shapes from 1e-100 to 1e100, and rays whose direction is as short or as long: `t` counts
/// in lengths of the direction. 1e100 is no power of two; bound: a few roundings.
#[test]
fn the_smallest_and_largest_shapes_are_hit() {
    for (size, length) in [
        (1.0, 1e-100),
        (1.0, 0.5),
        (1.0, 8.0),
        (1.0, 1e100),
        (1e-100, 1.0),
        (1e-100, 1e-100),
        (1e100, 1.0),
        (1e100, 1e100),
    ] {
        let ray = ray([0.0, 0.0, 3.0 * size], [0.0, 0.0, -length]);
        for shape in shapes(size) {
            let found = hit(&*shape, &ray).unwrap_or_else(|| panic!("{shape:?} {ray:?}"));
            let expected = 2.0 * (size / length);
            assert_relative_eq!(found.t, expected, max_relative = 8.0 * f64::EPSILON);
            assert_eq!((found.normal, found.face), (Z, Z));
        }
    }
}

/// A direction twice as long halves `t` exactly.
#[test]
fn a_direction_of_another_length_changes_t_alone() {
    for n in 0..8000 {
        let (shape, ray) = (random_shape(n / 8), random_ray(n));
        let found = |ray: &Ray| hit(&*shape, ray).map(|hit| (hit.t, hit.normal, hit.face));
        for exponent in [-300, -1, 1, 300] {
            let length = libm::scalbn(1.0, exponent);
            let scaled = found(&Ray::derived(ray.origin(), ray.direction() * length));
            let scaled = scaled.map(|(t, normal, face)| (t * length, normal, face));
            assert_eq!(scaled, found(&ray), "{shape:?} {ray:?} 2^{exponent}");
        }
    }
}

#[test]
fn a_ray_of_no_numbers_hits_nothing() {
    for shape in shapes(1.0) {
        for bad in [f64::NAN, f64::INFINITY] {
            let nowhere = ray([0.0, 0.0, bad], [0.0, 0.0, -1.0]);
            assert_eq!(hit(&*shape, &nowhere), None, "{shape:?}");
            let beside = ray([bad, 0.0, 3.0], [0.0, 0.0, bad]);
            assert_eq!(hit(&*shape, &beside), None, "{shape:?}");
        }
        let still = ray([0.0, 0.0, 3.0], [0.0; 3]);
        assert_eq!(hit(&*shape, &still), None, "{shape:?}");
    }
}

#[test]
fn bad_coordinates_are_refused_by_name() {
    let good = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        let wrong = point([0.0, bad, 0.0]);
        let allowed = "from -1e100 to 1e100";
        assert_refused(Plane::new(wrong, Z), "point a is", allowed);
        assert_refused(Sphere::new(wrong, 1.0), "centre c is", allowed);
        let aab = AxisAlignedBox::new(wrong, good[0]);
        assert_refused(aab, "corner lbf is", allowed);
        let aab = AxisAlignedBox::new(good[0], wrong);
        assert_refused(aab, "corner run is", allowed);
        for (n, name) in (0..).zip(["corner a is", "corner b is", "corner c is"]) {
            let mut corners = good;
            corners[n] = wrong;
            let [a, b, c] = corners;
            assert_refused(Triangle::new(a, b, c), name, allowed);
        }
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-101, 1e101] {
        let sphere = Sphere::new(Point3::ORIGIN, bad);
        assert_refused(sphere, "radius r is", "from 1e-100 to 1e100");
    }
}

#[test]
fn bad_normals_are_refused_by_name() {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    let triangle = Triangle::new(a, b, c).unwrap();
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let wrong = Normal3::new(bad, 0.0, 0.0);
        let allowed = "not all of them 0";
        assert_refused(Plane::new(a, wrong), "normal n is", allowed);
        for (n, name) in (0..).zip(["normal of a", "normal of b", "normal of c"]) {
            let mut normals = [Z; 3];
            normals[n] = wrong;
            assert_refused(triangle.with_normals(normals), name, allowed);
        }
    }
}
