//! Discs: their rim, and the arguments that their constructor refuses. A unit in the last
//! place outside of the rim, and rays within the plane, are the extreme cases B14 and B18.

use a02_math::{Normal3, Point3};
use a04_intersections::{Geometry, Interval};
use a07_transforms::Disc;
use testing::assert_refused;

use super::support::{assert_hits, point, ray};

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const UP: [f64; 3] = [0.0, 1.0, 0.0];
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

/// Lying flat around the origin.
fn disc(r: f64) -> Disc {
    Disc::new(Point3::ORIGIN, UPWARDS, r).unwrap()
}

/// 3² + 4² = 5²; and 1² + 1² = 2, which is less than the square of the rounded
/// root of 2. Beyond, 1² + 1.6e-8² is more than 1, but its rounded root is 1.
#[test]
fn the_rim_belongs_to_the_disc_and_nothing_beyond() {
    for (r, x, z) in [
        (5.0, 3.0, 4.0),
        (5.0, -4.0, 3.0),
        (5.0, 0.0, -5.0),
        (2_f64.sqrt(), -1.0, 1.0),
        (1e-100, 1e-100, 0.0),
        (1e100, 0.6e100, 0.7e100),
    ] {
        let (above, below) = ([x, 2.0, z], [x, -3.0, z]);
        assert_hits(
            &disc(r),
            &[
                (above, DOWN, Some((2.0, UP))),
                (below, UP, Some((3.0, UP))),
                (above, UP, None),
                // From the disc.
                ([x, 0.0, z], DOWN, None),
            ],
        );
        let beyond = [1.1 * x, 2.0, 1.1 * z];
        assert_hits(&disc(r), &[(beyond, DOWN, None)]);
    }
    assert_hits(&disc(1.0), &[([1.0, 2.0, 1.6e-8], DOWN, None)]);
    // `t` counts in lengths of the direction, and the end of an interval does not belong
    // to it.
    let (disc, ray) = (disc(5.0), ray(UP, [0.0, -4.0, 0.0]));
    let t = |min| Some(disc.hit(&ray, Interval { min, max: 1.0 })?.t);
    assert_eq!((t(0.0), t(0.25)), (Some(0.25), None));
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
