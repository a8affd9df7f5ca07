//! Highlights: where they are, how bright, and where there are none.

use a02_math::Vector3;
use a03_rays_cameras::PixelRandom;
use approx::assert_abs_diff_eq;
use common::Color;

use super::{
    Given, LEFT, RIGHT, ROUNDING, UP, assert_close, lambert, light_from, phong, seen_from,
};

/// The light comes from the right; its mirror direction is on the left. The
/// cosine between that and the eye is 1 there, 0.8 from above, and 0.28 =
/// 0.8² - 0.6² from where the light is.
#[test]
fn a_highlight_is_the_power_of_the_cosine_to_the_mirrored_light() {
    let (diffuse, specular) = (Color::new(0.5, 0.0, 0.25), Color::new(0.0, 0.5, 1.0));
    let light = Color::new(1.0, 1.0, 0.5);
    let lighting = light_from(&[(light, RIGHT)]);
    for (e, cosine) in [(LEFT, 1.0), (UP, 0.8), (RIGHT, 0.28)] {
        let square: f64 = cosine * cosine;
        for (exponent, power) in [
            (0.0, 1.0),
            (1.0, cosine),
            (2.0, square),
            (0.5, cosine.sqrt()),
        ] {
            let color = seen_from(e, &phong(diffuse, specular, exponent), &lighting);
            let matt = diffuse * light * 0.8;
            assert_close(color, matt + specular * light * power);
        }
    }
}

#[test]
fn highlights_add_up_and_the_surface_does_not_tint_them() {
    let material = phong(Color::RED, Color::WHITE, 2.0);
    let lighting = Given {
        ambient: Color::new(0.125, 1.0, 1.0),
        ..light_from(&[(Color::GREEN, RIGHT), (Color::gray(0.5), LEFT)])
    };
    let highlight = 0.8 * 0.8;
    let expected = Color::new(
        0.125 + 0.5 * 0.8 + 0.5 * highlight,
        1.5 * highlight,
        0.5 * highlight,
    );
    assert_close(seen_from(UP, &material, &lighting), expected);
}

/// 0 to the power of 0 is 1: it must not light a surface that faces away.
#[test]
fn beyond_a_right_angle_no_exponent_makes_a_highlight() {
    let lighting = light_from(&[(Color::WHITE, RIGHT)]);
    // Perpendicular to the mirror direction (-0.6, 0.8), and beyond.
    for e in [
        Vector3::new(0.8, 0.6, 0.0),
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, 0.0, 1.0) - LEFT * 0.01,
    ] {
        for exponent in [0.0, 1e-300, 1.0, 64.0] {
            let color = seen_from(e, &phong(Color::BLACK, Color::WHITE, exponent), &lighting);
            assert_eq!(color, Color::BLACK);
        }
    }
}

/// A light below the surface or exactly in its plane would be mirrored towards
/// eyes just above it.
#[test]
fn light_from_behind_makes_no_highlight() {
    for exponent in [0.0, 1.0, 64.0] {
        let material = phong(Color::WHITE, Color::WHITE, exponent);
        for direction in [
            Vector3::new(0.6, -0.8, 0.0),
            Vector3::new(1.0, 0.0, 0.0),
            -UP,
        ] {
            let lighting = light_from(&[(Color::WHITE, direction)]);
            for e in [UP, LEFT, Vector3::new(-1.0, 1e-9, 0.0)] {
                assert_eq!(seen_from(e, &material, &lighting), Color::BLACK);
            }
        }
    }
}

/// Cosines of rounded vectors exceed 1 by a few units of rounding, which a
/// high power turns into millions.
#[test]
fn no_highlight_is_brighter_than_its_light() {
    let material = phong(Color::BLACK, Color::WHITE, 1e17);
    let mut peaks = 0;
    for n in 0..10_000 {
        let random = PixelRandom::new(9, n, 0);
        let [x, z] = [0, 1].map(|i| random.uniform(i) * 4.0 - 2.0);
        let l = Vector3::new(x, 1.0, z).normalized().unwrap();
        let mirrored = Vector3::new(-l.x(), l.y(), -l.z());
        let color = seen_from(mirrored, &material, &light_from(&[(Color::WHITE, l)]));
        assert!((0.0..=1.0).contains(&color.r), "{color:?}");
        peaks += u32::from(color.r == 1.0);
    }
    assert!(peaks > 1000, "the clamp is tested");
}

#[test]
fn with_a_black_specular_a_shiny_surface_is_matt() {
    let diffuse = Color::new(0.3, 0.6, 0.9);
    for exponent in [0.0, 1.0, 64.0] {
        let dull = phong(diffuse, Color::BLACK, exponent);
        for e in [UP, LEFT, RIGHT] {
            let lighting = light_from(&[(Color::new(0.7, 0.1, 2.0), RIGHT), (Color::RED, LEFT)]);
            let expected = seen_from(e, &lambert(diffuse), &lighting);
            assert_eq!(seen_from(e, &dull, &lighting), expected);
        }
    }
}

/// Light and surface of 1e50 make 1e100 of ambient light, of matt light and of
/// a highlight. Tolerance: rounding of a few products.
#[test]
fn the_brightest_colors_make_a_number() {
    let brightest = Color::gray(1e50);
    let material = phong(brightest, brightest, 1.0);
    let lighting = Given {
        ambient: brightest,
        ..light_from(&[(brightest, UP)])
    };
    for channel in seen_from(UP, &material, &lighting).channels() {
        assert_abs_diff_eq!(channel / 1e100, 3.0, epsilon = ROUNDING);
    }
}
