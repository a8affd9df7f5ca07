//! Steps and chains that are refused.

use a02_math::Point3;
use a07_transforms::Transform;
use common::ArgumentError;

fn refusal(transform: Result<Transform, ArgumentError>) -> String {
    transform.unwrap_err().to_string()
}

#[test]
fn bad_steps_are_refused_by_name() {
    let start = Transform::IDENTITY;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for said in [
            start.rotate_x(bad),
            start.rotate_y(bad),
            start.rotate_z(bad),
        ]
        .map(refusal)
        {
            assert!(said.starts_with("angle is"), "{said}");
            assert!(said.contains("a finite number"), "{said}");
        }
    }
    for bad in [f64::NAN, f64::INFINITY, -1e101] {
        let said = refusal(start.translate(Point3::new(0.0, bad, 0.0)));
        assert!(said.starts_with("translation is"), "{said}");
        assert!(said.contains("from -1e100 to 1e100"), "{said}");
    }
}

/// Flat objects have lost a coordinate, and no inverse gives it back.
#[test]
fn scales_of_zero_or_out_of_range_are_refused_by_name() {
    let start = Transform::IDENTITY;
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY, 1e-101, -1e-101, 1e101] {
        for (scale, name) in [
            (start.scale(bad, 1.0, 1.0), "scale x is"),
            (start.scale(1.0, bad, 1.0), "scale y is"),
            (start.scale(1.0, 1.0, bad), "scale z is"),
        ] {
            let said = refusal(scale);
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("magnitude is from 1e-100 to 1e100"), "{said}");
        }
    }
    for good in [1e-100, -1e-100, 1e100, -1e100] {
        assert!(start.scale(good, good, good).is_ok());
    }
}

#[test]
fn chains_too_large_for_numbers_are_refused() {
    for factor in [1e100, 1e-100] {
        let scale = |transform: Transform| transform.scale(factor, factor, factor);
        let said = refusal(scale(Transform::IDENTITY).and_then(scale));
        assert!(said.starts_with("transform is too large"), "{said}");
        assert!(said.contains("no number above 1e150"), "{said}");
    }
}
