//! Laws of every shape: open intervals, the ends of the allowed range, rays of no
//! numbers, and arguments that are refused. That scale and place of a scene change no bit are
//! the extreme cases S12 and I11.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle};
use testing::assert_refused;

use crate::test_shapes::{hit, point, random_ray, random_shapes, ray};

const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);

#[test]
fn the_ends_of_an_interval_do_not_belong_to_it() {
    let mut second_hits = 0;
    for shape in (0..60).flat_map(random_shapes) {
        for ray in (0..40).map(random_ray) {
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
    }
    println!("{second_hits}");
    assert!(second_hits > 400, "{second_hits} rays leave a shape");
}

/// A direction twice as long halves `t` exactly.
#[test]
fn a_direction_of_another_length_changes_t_alone() {
    for shape in (0..60).flat_map(random_shapes) {
        for ray in (0..40).map(random_ray) {
            let found =
                |ray: &Ray| hit(&*shape, ray).map(|hit| (hit.t, hit.normal, hit.geometric_normal));
            for exponent in [-960, -332, -1, 1, 332, 960] {
                let length = libm::scalbn(1.0, exponent);
                let scaled = found(&Ray::derived(ray.origin(), ray.direction() * length));
                let scaled = scaled.map(|(t, normal, face)| (t * length, normal, face));
                assert_eq!(scaled, found(&ray), "{shape:?} {ray:?} 2^{exponent}");
            }
        }
    }
}

#[test]
fn a_ray_of_no_numbers_hits_nothing() {
    let [a, b, c] = [[-1.0, -1.0, 1.0], [1.0, -1.0, 1.0], [0.0, 1.0, 1.0]].map(point);
    let shapes: [Box<dyn Geometry>; 4] = [
        Box::new(Plane::new(a, Z).unwrap()),
        Box::new(Sphere::new(Point3::ORIGIN, 1.0).unwrap()),
        Box::new(AxisAlignedBox::new(a, point([1.0, 1.0, -1.0])).unwrap()),
        Box::new(Triangle::new(a, b, c).unwrap()),
    ];
    for shape in shapes {
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
fn bad_coordinates_and_normals_are_refused_by_name() {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    let allowed = "from -1e100 to 1e100";
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        let wrong = point([0.0, bad, 0.0]);
        assert_refused(Plane::new(wrong, Z), "point a is", allowed);
        assert_refused(Sphere::new(wrong, 1.0), "centre c is", allowed);
        assert_refused(AxisAlignedBox::new(wrong, a), "corner lbf is", allowed);
        assert_refused(AxisAlignedBox::new(a, wrong), "corner run is", allowed);
        assert_refused(Triangle::new(wrong, b, c), "corner a is", allowed);
        assert_refused(Triangle::new(a, wrong, c), "corner b is", allowed);
        assert_refused(Triangle::new(a, b, wrong), "corner c is", allowed);
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-101, 1e101] {
        let sphere = Sphere::new(a, bad);
        assert_refused(sphere, "radius r is", "from 1e-100 to 1e100");
    }
    let triangle = Triangle::new(a, b, c).unwrap();
    let allowed = "not all of them 0";
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let wrong = Normal3::new(bad, 0.0, 0.0);
        assert_refused(Plane::new(a, wrong), "normal n is", allowed);
        assert_refused(triangle.with_normals([wrong, Z, Z]), "normal of a", allowed);
        assert_refused(triangle.with_normals([Z, wrong, Z]), "normal of b", allowed);
        assert_refused(triangle.with_normals([Z, Z, wrong]), "normal of c", allowed);
    }
}
