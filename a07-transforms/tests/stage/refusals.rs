//! Arguments that transforms and discs refuse. Each step, the inverse of a chain, and the rim of a disc
//! are held by the extreme cases B12 to B22 and G01 to G32 and by exercises.

use a02_math::arrays::point;
use a02_math::{Normal3, Point3};
use a07_transforms::{Disc, Transform};
use testing::assert_refused;

const START: Transform = Transform::IDENTITY;
const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);

#[test]
fn bad_steps_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for rotate in [
            Transform::rotate_x,
            Transform::rotate_y,
            Transform::rotate_z,
        ] {
            assert_refused(rotate(START, bad), "angle is", "a finite number");
        }
        let translated = START.translate(point([0.0, bad, 0.0]));
        assert_refused(translated, "translation is", "from -1e100 to 1e100");
    }
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY, 1e-101, -1e-101, 1e101] {
        for (scaled, name) in [
            (START.scale(bad, 1.0, 1.0), "scale x is"),
            (START.scale(1.0, bad, 1.0), "scale y is"),
            (START.scale(1.0, 1.0, bad), "scale z is"),
        ] {
            assert_refused(scaled, name, "magnitude is from 1e-100 to 1e100");
        }
    }
    for factor in [1e100, 1e-100, -1e-100] {
        let once = START.scale(factor, factor, factor).unwrap();
        let twice = once.scale(factor, factor, factor);
        assert_refused(twice, "transform is too large", "no number above 1e150");
    }
}

#[test]
fn bad_discs_are_refused_by_name() {
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
