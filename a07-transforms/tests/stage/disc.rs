//! Discs: their rim, and the arguments that they refuse. A unit in the last place outside of
//! the rim, and rays within the plane, are the extreme cases B14 and B18.

use a02_math::{Normal3, Point3};
use a04_intersections::{Geometry, Interval};
use a07_transforms::Disc;
use testing::assert_refused;

use a04_lab::test_shapes::{assert_hits, point, ray};

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);

/// 3² + 4² = 5²; and 1² + 1.6e-8² is more than 1, but its rounded root is 1.
#[test]
fn the_rim_belongs_to_the_disc_and_nothing_beyond() {
    let hit = Some((2.0, [0.0, 1.0, 0.0]));
    for (r, x, z, expected) in [(5.0, 3.0, 4.0, hit), (1.0, 1.0, 1.6e-8, None)] {
        let disc = Disc::new(Point3::ORIGIN, UPWARDS, r).unwrap();
        assert_hits(&disc, &[([x, 2.0, z], [0.0, -1.0, 0.0], expected)]);
    }
}

/// Rays that start on a disc hit it at 0, which is ahead of none of them; and rays within its plane
/// miss it.
#[test]
fn rays_from_a_disc_and_within_its_plane() {
    let disc = Disc::new(Point3::ORIGIN, UPWARDS, 5.0).unwrap();
    let around = Interval {
        min: -1.0,
        max: 1.0,
    };
    for (o, is_on_disc) in [
        ([0.0; 3], true),
        ([3.0, 0.0, 4.0], true),
        ([3.0, 0.0, 4.0_f64.next_up()], false),
    ] {
        for d in [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [2.0, 1.0, -1.0]] {
            let ray = ray(o, d);
            assert_eq!(disc.hit(&ray, Interval::AHEAD), None, "{ray:?}");
            let t = disc.hit(&ray, around).map(|hit| hit.t);
            assert_eq!(t, is_on_disc.then_some(0.0), "{ray:?}");
        }
        for d in [[1.0, 0.0, 0.0], [-3.0, -0.0, -4.0]] {
            let ray = ray(o, d);
            for within in [Interval::AHEAD, around] {
                assert_eq!(disc.hit(&ray, within), None, "{ray:?}");
            }
        }
    }
}

#[test]
fn bad_arguments_are_refused_by_name() {
    for bad in [0.0, -2.0, f64::NAN, f64::INFINITY, 1e-170, 1e101] {
        let disc = Disc::new(Point3::ORIGIN, UPWARDS, bad);
        assert_refused(disc, "radius r is", "from 1e-100 to 1e100");
    }
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        let disc = Disc::new(point([bad, 0.0, 0.0]), UPWARDS, 1.0);
        assert_refused(disc, "centre c is", "from -1e100 to 1e100");
    }
    for bad in [0.0, f64::NAN, f64::NEG_INFINITY] {
        let disc = Disc::new(Point3::ORIGIN, Normal3::new(0.0, bad, 0.0), 1.0);
        assert_refused(disc, "normal n is", "not all of them 0");
    }
}
