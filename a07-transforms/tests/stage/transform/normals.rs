//! Normals of transformed objects.

use a02_math::{Direction, Normal3, Vector3};
use a03_rays_cameras::PixelRandom;
use approx::assert_abs_diff_eq;

use super::{ROUNDING, scaled, translated};

fn unit(x: f64, y: f64, z: f64) -> Normal3 {
    Normal3::new(x, y, z).normalized().unwrap()
}

#[test]
fn normals_lean_away_from_where_the_object_is_stretched() {
    let diagonal = unit(1.0, 1.0, 0.0);
    for (transform, expected) in [
        (scaled(1.0, 0.5, 1.0), unit(1.0, 2.0, 0.0)),
        (scaled(1.0, 1e-8, 1.0), unit(1e-8, 1.0, 0.0)),
        (scaled(6.0, 1.0, 4.0), unit(1.0, 6.0, 0.0)),
        (scaled(2.0, 2.0, 2.0), diagonal),
        (scaled(1e-100, 1e-100, 1e-100), diagonal),
        (scaled(1e100, 1e100, 1e100), diagonal),
        (translated(5.0, -7.0, 9.0), diagonal),
        (scaled(-1.0, 1.0, 1.0), unit(-1.0, 1.0, 0.0)),
        (scaled(-2.0, -1.0, -1.0), unit(-1.0, -2.0, 0.0)),
    ] {
        let normal = transform.normal_from_object(diagonal).unwrap();
        assert_abs_diff_eq!(normal, expected, epsilon = ROUNDING);
    }
}

/// Of a moved, turned and stretched object. Bound: 8 eps of the length of the
/// tangent, times the ratio of the stretches, for the normal is only as long
/// as its least stretched part.
#[test]
fn normals_stay_perpendicular_to_the_surface_and_of_length_1() {
    for n in 0..2000 {
        let random = PixelRandom::new(16, n, 0);
        let any = |i: u64| 4.0 * random.uniform(i) - 2.0;
        let stretch = [0, 1, 2].map(|i| {
            let factor = 0.1 + 9.9 * random.uniform(i);
            if random.uniform(i + 3) < 0.3 {
                -factor
            } else {
                factor
            }
        });
        let [sx, sy, sz] = stretch;
        let transform = translated(any(6), any(7), any(8))
            .rotate_x(any(9))
            .and_then(|transform| transform.scale(sx, sy, sz))
            .and_then(|transform| transform.rotate_y(any(10)))
            .unwrap();
        let normal = unit(any(11), any(12), any(13));
        let tangent = Vector3::new(any(14), any(15), any(16)).cross(normal.into());
        let moved = transform.matrix() * tangent;
        let turned = transform.normal_from_object(normal).unwrap();
        let bound = 8.0 * f64::EPSILON * 100.0 * moved.magnitude();
        assert_abs_diff_eq!(turned.dot(moved), 0.0, epsilon = bound);
        assert_abs_diff_eq!(turned.dot(turned), 1.0, epsilon = ROUNDING);
        // The outside stays outside.
        let outwards = transform.matrix() * Vector3::from(normal);
        assert!(turned.dot(outwards) > 0.0);
    }
}

#[test]
fn what_has_no_direction_has_no_normal() {
    let transform = scaled(1.0, 2.0, 3.0);
    assert_eq!(transform.normal_from_object(Normal3::default()), None);
    let nan = Normal3::new(f64::NAN, 0.0, 0.0);
    assert_eq!(transform.normal_from_object(nan), None);
}
