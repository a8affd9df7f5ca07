//! Highlights: their place and brightness, and where there are none. Cosines that rounding
//! lifts above 1 are the extreme case F17.

use a02_math::Vector3;
use common::Color;

use super::{LEFT, RIGHT, UP, assert_close, light, phong, seen_from, white_from};

/// The light comes from the right; its mirror direction is on the left. The
/// cosine between that and the eye is 1 there, 0.8 from above, and 0.28 =
/// 0.8² - 0.6² from where the light is.
#[test]
fn a_highlight_is_the_power_of_the_cosine_to_the_mirrored_light() {
    let (diffuse, specular) = (Color::new(0.5, 0.0, 0.25), Color::new(0.0, 0.5, 1.0));
    let color = Color::new(1.0, 1.0, 0.5);
    let lighting = light(Color::BLACK, &[(color, RIGHT)]);
    for (e, cosine) in [(LEFT, 1.0), (UP, 0.8), (RIGHT, 0.28_f64)] {
        for (exponent, power) in [
            (0.0, 1.0),
            (1.0, cosine),
            (2.0, cosine * cosine),
            (0.5, cosine.sqrt()),
        ] {
            let found = seen_from(e, &phong(diffuse, specular, exponent), &lighting);
            assert_close(found, color * (diffuse * 0.8 + specular * power));
        }
    }
}

/// With the light in the normal, so that `e · r` is the height of the eye. Whole exponents
/// up to 1024 multiply, with at most the error of rounding the base, half of epsilon times
/// the exponent, and as much for the products.
#[test]
fn powers_are_exact_where_they_can_be() {
    let power = |base: f64, exponent| {
        let e = Vector3::new(libm::sqrt(1.0 - base * base), base, 0.0);
        seen_from(
            e,
            &phong(Color::BLACK, Color::WHITE, exponent),
            &white_from(UP),
        )
        .r
    };
    for (base, exponent, expected) in [
        (0.5, 63.0, 1.0 / (1_u64 << 63) as f64),
        (0.75, 5.0, 243.0 / 1024.0),
        (0.25, 2.5, 1.0 / 32.0),
        (1.0, 1024.0, 1.0),
        (1.0, 1e300, 1.0),
        (0.5, 1e300, 0.0),
    ] {
        assert_eq!(power(base, exponent), expected, "{base} to the {exponent}");
    }
    for base in (1..100_u32).map(|i| f64::from(i) / 100.0) {
        assert_eq!(power(base, 3.0), base * (base * base));
    }
    for exponent in [64.0, 1000.0, 1024.0] {
        let base = 1.0 - 0.7 / exponent;
        let error = power(base, exponent) / libm::pow(base, exponent) - 1.0;
        assert!(error.abs() <= exponent * f64::EPSILON, "{exponent}");
    }
}

/// 0 to the power of 0 is 1: it must not light a surface that faces away, neither
/// perpendicular to the mirror direction (-0.6, 0.8) nor beyond. A light below the surface
/// or exactly in its plane would be mirrored towards eyes just above it.
#[test]
fn beyond_a_right_angle_no_exponent_makes_a_highlight() {
    let x = Vector3::new(1.0, 0.0, 0.0);
    let before = Vector3::new(0.0, 0.0, 1.0) - LEFT * 0.01;
    let just_above = Vector3::new(-1.0, 1e-9, 0.0);
    for (from, eyes) in [
        (RIGHT, [Vector3::new(0.8, 0.6, 0.0), x, before]),
        (Vector3::new(0.6, -0.8, 0.0), [UP, LEFT, just_above]),
        (x, [UP, LEFT, just_above]),
        (-UP, [UP, LEFT, just_above]),
    ] {
        for exponent in [0.0, 1e-300, 1.0, 64.0] {
            let material = phong(Color::BLACK, Color::WHITE, exponent);
            for e in eyes {
                let color = seen_from(e, &material, &white_from(from));
                assert_eq!(color, Color::BLACK, "from {from:?} to {e:?}");
            }
        }
    }
}
