//! Spheres: from near, from far away, from inside and along their border.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use approx::{assert_abs_diff_eq, assert_relative_eq};

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn unit_sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

/// From (`x`, `y`, `z`), straight ahead.
fn ahead(x: f64, y: f64, z: f64) -> Ray {
    Ray::derived(Point3::new(x, y, z), AHEAD)
}

fn hit(sphere: &Sphere, ray: &Ray) -> Option<Hit> {
    sphere.hit(ray, Interval::AHEAD)
}

fn t(sphere: &Sphere, ray: &Ray) -> Option<f64> {
    hit(sphere, ray).map(|hit| hit.t)
}

/// Tolerance: the error of the formula, 4 eps of the distance.
#[test]
fn a_ray_meets_the_near_side() {
    let front = Vector3::new(0.0, 0.0, 1.0).as_normal();
    let found = hit(&unit_sphere(), &ahead(0.0, 0.0, 3.0));
    assert_eq!(found, Some(Hit::new(2.0, front)));
    // 0.6² + 0.8² = 1.
    let found = hit(&unit_sphere(), &ahead(0.6, 0.0, 5.0)).unwrap();
    let rounding = 4.0 * f64::EPSILON * 5.0;
    assert_abs_diff_eq!(found.t, 4.2, epsilon = rounding);
    let normal = Vector3::new(0.6, 0.0, 0.8).as_normal();
    assert_abs_diff_eq!(found.normal, normal, epsilon = rounding);
    assert_eq!(found.face, found.normal);
    assert_eq!(hit(&unit_sphere(), &ahead(1.1, 0.0, 5.0)), None);
    assert_eq!(hit(&unit_sphere(), &ahead(0.0, 0.0, -3.0)), None, "behind");
}

#[test]
fn from_inside_the_far_side_is_met_with_a_normal_outwards() {
    let back = AHEAD.as_normal();
    assert_eq!(t(&unit_sphere(), &ahead(0.0, 0.0, 0.0)), Some(1.0));
    let found = hit(&unit_sphere(), &ahead(0.0, 0.0, 0.5)).unwrap();
    assert_eq!(found, Hit::new(1.5, back));
    let found = hit(&unit_sphere(), &ahead(0.0, 0.0, -0.5)).unwrap();
    assert_eq!(found, Hit::new(0.5, back));
}

#[test]
fn from_the_surface_the_ray_sees_the_other_side_only() {
    assert_eq!(t(&unit_sphere(), &ahead(0.0, 0.0, -1.0)), None, "outwards");
    assert_eq!(t(&unit_sphere(), &ahead(0.0, 0.0, 1.0)), Some(2.0));
    assert_eq!(t(&unit_sphere(), &ahead(1.0, 0.0, 0.0)), None, "along it");
    // However small the sphere is.
    let small = Sphere::new(Point3::ORIGIN, 1e-4).unwrap();
    assert_eq!(t(&small, &ahead(0.0, 0.0, 1e-4)), Some(2e-4));
}

#[test]
fn the_ends_of_the_interval_do_not_count() {
    let t = |min, max| {
        let hit = unit_sphere().hit(&ahead(0.0, 0.0, 3.0), Interval { min, max });
        hit.map(|hit| hit.t)
    };
    assert_eq!(t(2_f64.next_down(), 9.0), Some(2.0));
    assert_eq!(t(0.0, 2.0), None);
    assert_eq!(t(2.0, 9.0), Some(4.0), "the near side is not asked for");
    assert_eq!(t(2.0, 4.0), None);
    assert_eq!(t(4.0, 9.0), None);
}

/// With y = 1 - 2^-53 half of the chord is sqrt(1 - y²), 1.49e-8, which the
/// subtraction of squares must not lose. Tolerance: 2 units of rounding of 5.
#[test]
fn tangents_belong_to_the_sphere_and_rounding_does_not_widen_it() {
    let along_x = |y: f64| {
        let o = Point3::new(-5.0, y, 0.0);
        t(
            &unit_sphere(),
            &Ray::derived(o, Vector3::new(1.0, 0.0, 0.0)),
        )
    };
    assert_eq!(along_x(1.0), Some(5.0));
    assert_eq!(along_x(1_f64.next_up()), None);
    assert_eq!(along_x(-1_f64.next_up()), None);
    let inside = along_x(1_f64.next_down()).unwrap();
    assert_abs_diff_eq!(inside, 4.999_999_985_098_839, epsilon = 1.8e-15);
}

/// Bound: 4 eps R / cos, in units of the radius, R being the distance. Of
/// these, 2 are the formula's and up to 1 the rounded direction's, which at a
/// distance of 2e8 leads beside the point aimed at. All other numbers are
/// exact: multiples of 2^-20 times (1, 2, 2) and (2, 1, -2), two perpendicular
/// vectors of length 3.
#[test]
fn a_sphere_far_away_is_met_as_exactly_as_its_distance_allows() {
    let (towards, aside) = (Vector3::new(1.0, 2.0, 2.0), Vector3::new(2.0, 1.0, -2.0));
    let distance = 3.0 * 67_108_864.0;
    for n in (-345_000..=345_000).step_by(1000) {
        let beside = f64::from(n) / 1_048_576.0;
        let o = Point3::ORIGIN + aside * beside - towards * (distance / 3.0);
        let cosine = (1.0 - 9.0 * beside * beside).sqrt();
        let found = t(&unit_sphere(), &Ray::new(o, towards).unwrap()).unwrap();
        let bound = 4.0 * f64::EPSILON * distance / cosine;
        assert_abs_diff_eq!(found, distance - cosine, epsilon = bound);
    }
}

#[test]
fn rays_that_pass_a_sphere_far_away_miss_it() {
    for distance in [1e8, 1e9, 1e12] {
        for beside in [1.0 + 1e-9, 1.5, 2.0] {
            let ray = ahead(beside, 0.0, distance);
            assert_eq!(hit(&unit_sphere(), &ray), None);
        }
        let found = t(&unit_sphere(), &ahead(0.0, 0.0, distance)).unwrap();
        let bound = 4.0 * f64::EPSILON * distance;
        assert_abs_diff_eq!(found, distance - 1.0, epsilon = bound);
    }
}

/// Bound: 4 eps of the distance or the radius, whichever is greater, for the
/// formula, and as much for the direction, for `at` and for checking. Along the
/// ray it is more by the cosine, away from the surface not.
#[test]
fn every_hit_lies_on_the_sphere_with_a_normal_from_the_centre() {
    let (c, r) = (Point3::new(3.0, -2.0, 0.5), 1.75);
    let sphere = Sphere::new(c, r).unwrap();
    let mut hits = 0;
    for n in 0..5000 {
        let random = PixelRandom::new(2, n, 0);
        let from = |i| 20.0 * random.uniform(i) - 10.0;
        let o = Point3::new(from(0), from(1), from(2));
        let beside = [3, 4, 5].map(|i| 3.0 * random.uniform(i) - 1.5);
        let ray = Ray::new(o, c + Vector3::from_glam(beside.into()) - o).unwrap();
        let Some(found) = hit(&sphere, &ray) else {
            continue;
        };
        hits += 1;
        let from_centre = ray.at(found.t) - c;
        let bound = 8.0 * f64::EPSILON * (o - c).magnitude().max(r);
        let cosine = found.normal.dot(ray.direction()).abs();
        assert_abs_diff_eq!(from_centre.magnitude(), r, epsilon = bound);
        let normal = (from_centre * (1.0 / r)).as_normal();
        assert_abs_diff_eq!(found.normal, normal, epsilon = bound / cosine / r);
        let entering = found.normal.dot(ray.direction()) < 0.0;
        assert_eq!(entering, (o - c).magnitude() > r);
    }
    assert!(hits > 2000);
}

/// Also at both ends of the range of lengths, where the product of four of
/// them would vanish or be infinite: a sphere of radius 1e100 that a transform
/// shrinks to 1, or one of radius 1e-100 that is stretched.
#[test]
fn t_counts_in_lengths_of_the_direction() {
    for (r, length) in [
        (1.0, 0.5),
        (1.0, 8.0),
        (1.0, 1e-100),
        (1.0, 1e100),
        (1e-100, 1e-100),
        (1e100, 1e100),
    ] {
        let sphere = Sphere::new(Point3::ORIGIN, r).unwrap();
        let ray = Ray::derived(Point3::new(0.0, 0.0, 3.0 * r), AHEAD * length);
        let found = t(&sphere, &ray).unwrap();
        let rounding = 8.0 * f64::EPSILON;
        assert_relative_eq!(found, 2.0 * (r / length), max_relative = rounding);
    }
}

#[test]
fn a_ray_of_no_numbers_meets_nothing() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(hit(&unit_sphere(), &ahead(bad, 0.0, 3.0)), None);
        let anywhere = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, bad, 0.0));
        assert_eq!(hit(&unit_sphere(), &anywhere), None);
    }
    let still = Ray::derived(Point3::new(0.0, 0.0, 3.0), Vector3::default());
    assert_eq!(hit(&unit_sphere(), &still), None);
}

#[test]
fn bad_radii_and_centres_are_refused_by_name() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-101, 1e101] {
        let said = Sphere::new(Point3::ORIGIN, bad).unwrap_err().to_string();
        assert!(said.starts_with("radius r is"), "{said}");
        assert!(said.contains("from 1e-100 to 1e100"), "{said}");
    }
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        let said = Sphere::new(Point3::new(0.0, bad, 0.0), 1.0).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("centre c is"), "{said}");
        assert!(said.contains("from -1e100 to 1e100"), "{said}");
    }
    assert!(Sphere::new(Point3::ORIGIN, 1e-100).is_ok());
    assert!(Sphere::new(Point3::new(1e100, -1e100, 0.0), 1e100).is_ok());
}
