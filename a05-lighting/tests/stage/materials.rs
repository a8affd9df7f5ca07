//! Highlights that are exact, and surfaces that must not shine. Cosines that rounding lifts
//! above 1 are the extreme case F17; the formulas of all materials, the exercises.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{DirectionalLight, LitWorld, Material, Phong};
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// 0.6² + 0.8² = 1: both reflect into each other.
const LEFT: Vector3 = Vector3::new(-0.6, 0.8, 0.0);
const RIGHT: Vector3 = Vector3::new(0.6, 0.8, 0.0);

/// A white highlight on a black surface that faces upwards, seen from the direction `e`, in
/// white light.
fn highlight(exponent: f64, e: Vector3, from: Vector3) -> f64 {
    let material = Phong::new(Color::BLACK, Color::WHITE, exponent).unwrap();
    let light = DirectionalLight::new(Color::WHITE, -from).unwrap();
    let world = LitWorld::new(Color::BLACK, Color::WHITE).unwrap();
    let ray = Ray::derived(Point3::ORIGIN + e, -e);
    let hit = Hit::new(1.0, UP.as_normal());
    let color = material.color_for(&ray, &hit, &world.lit_by(Box::new(light)));
    color.r
}

/// With the light in the normal, so that `e · r` is the height of the eye. Whole exponents
/// up to 1024 multiply, with at most the error of rounding the base, half of epsilon times
/// the exponent, and as much for the products.
#[test]
fn powers_are_exact_where_they_can_be() {
    let power = |base: f64, exponent| {
        let e = Vector3::new(libm::sqrt(1.0 - base * base), base, 0.0);
        highlight(exponent, e, UP)
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
            for e in eyes {
                assert_eq!(highlight(exponent, e, from), 0.0, "from {from:?} to {e:?}");
            }
        }
    }
}
