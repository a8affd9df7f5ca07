//! Discs: their rim, and the arguments that they refuse. A unit in the last place outside of
//! the rim, and rays within the plane, are the extreme cases B14 and B18.

use a02_math::{Normal3, Point3};
use a07_transforms::Disc;
use testing::assert_refused;

use super::support::{assert_hits, point};

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
