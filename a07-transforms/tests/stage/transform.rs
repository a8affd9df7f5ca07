//! Steps that a transform refuses. Each step, and the inverse of a chain, are held by the
//! extreme cases G01 to G32 and the exercises `chain` and `under_transform`.

use a07_transforms::Transform;
use testing::assert_refused;

use a04_lab::test_shapes::point;

const START: Transform = Transform::IDENTITY;

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
