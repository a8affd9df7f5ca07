//! Discs: their rim, and the arguments that their constructor refuses.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use a07_transforms::Disc;

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);

/// Lying flat around the origin.
fn disc(r: f64) -> Disc {
    Disc::new(Point3::ORIGIN, UPWARDS, r).unwrap()
}

/// From 2 above the place (`x`, `z`) straight down.
fn hit(disc: &Disc, x: f64, z: f64) -> Option<Hit> {
    let ray = Ray::derived(Point3::new(x, 2.0, z), DOWN);
    disc.hit(&ray, Interval::AHEAD)
}

/// 3² + 4² = 5²; and 1² + 1² = 2, which is less than the square of the rounded
/// root of 2. Beyond, 1² + 1.6e-8² is more than 1, but its rounded root is 1.
#[test]
fn the_rim_belongs_to_the_disc_and_nothing_beyond() {
    for (r, x, z) in [
        (5.0, 3.0, 4.0),
        (5.0, -4.0, 3.0),
        (5.0, 0.0, -5.0),
        (5.0, 5.0, 0.0),
        (2_f64.sqrt(), 1.0, 1.0),
        (2_f64.sqrt(), -1.0, 1.0),
        (0.5, 0.5, 0.0),
    ] {
        assert_eq!(hit(&disc(r), x, z), Some(Hit::new(2.0, UPWARDS)));
        assert_eq!(hit(&disc(r * 0.999), x, z), None);
    }
    for (r, x, z) in [
        (5.0, 5_f64.next_up(), 0.0),
        (5.0, 0.0, -5_f64.next_up()),
        (5.0, 4.0, 3.001),
        (1.0, 1.0, 1.6e-8),
    ] {
        assert_eq!(hit(&disc(r), x, z), None);
    }
}

#[test]
fn a_disc_is_seen_from_both_sides_and_where_it_lies() {
    let c = Point3::new(10.0, 1.0, -20.0);
    for length in [1e-200, 3.0, 1e200] {
        let disc = Disc::new(c, UPWARDS * length, 5.0).unwrap();
        assert_eq!(hit(&disc, 13.0, -16.0), Some(Hit::new(1.0, UPWARDS)));
        assert_eq!(hit(&disc, 3.0, 4.0), None);
        let from_below = Ray::derived(Point3::new(13.0, -2.0, -16.0), -DOWN);
        let found = disc.hit(&from_below, Interval::AHEAD);
        assert_eq!(found, Some(Hit::new(3.0, UPWARDS)));
    }
}

#[test]
fn rays_within_the_disc_and_away_from_it_miss() {
    for zero in [0.0, -0.0] {
        for y in [0.0, 1.0] {
            let o = Point3::new(-9.0, y, 0.0);
            let ray = Ray::derived(o, Vector3::new(1.0, zero, 0.0));
            assert_eq!(disc(5.0).hit(&ray, Interval::AHEAD), None);
        }
    }
    let leaving = Ray::derived(Point3::new(1.0, 0.0, 1.0), DOWN);
    assert_eq!(disc(5.0).hit(&leaving, Interval::AHEAD), None);
    let away = Ray::derived(Point3::new(1.0, 2.0, 1.0), -DOWN);
    assert_eq!(disc(5.0).hit(&away, Interval::AHEAD), None);
}

#[test]
fn the_interval_is_open_and_t_counts_in_lengths() {
    let ray = Ray::derived(Point3::new(1.0, 2.0, 1.0), DOWN * 4.0);
    let t = |min, max| {
        let hit = disc(5.0).hit(&ray, Interval { min, max });
        hit.map(|hit| hit.t)
    };
    assert_eq!(t(0.0, 9.0), Some(0.5));
    assert_eq!(t(0.5, 9.0), None);
    assert_eq!(t(0.0, 0.5), None);
}

#[test]
fn tiny_and_huge_discs_keep_their_rim() {
    for r in [1e-100, 1e100] {
        assert!(hit(&disc(r), r, 0.0).is_some());
        assert!(hit(&disc(r), 0.6 * r, 0.7 * r).is_some());
        assert!(hit(&disc(r), 1.001 * r, 0.0).is_none());
    }
}

#[test]
fn bad_arguments_are_refused_by_name() {
    for bad in [0.0, -2.0, f64::NAN, f64::INFINITY, 1e-170, 1e101] {
        let said = Disc::new(Point3::ORIGIN, UPWARDS, bad).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("radius r is"), "{said}");
        assert!(said.contains("from 1e-100 to 1e100"), "{said}");
    }
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        let said = Disc::new(Point3::new(bad, 0.0, 0.0), UPWARDS, 1.0).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("centre c is"), "{said}");
        assert!(said.contains("from -1e100 to 1e100"), "{said}");
    }
    for bad in [0.0, f64::NAN, f64::NEG_INFINITY] {
        let said = Disc::new(Point3::ORIGIN, Normal3::new(0.0, bad, 0.0), 1.0).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("normal n is"), "{said}");
        assert!(said.contains("not all of them 0"), "{said}");
    }
}
