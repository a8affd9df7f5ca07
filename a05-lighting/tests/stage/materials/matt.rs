//! Matt surfaces, and surfaces of a single colour.

use a02_math::Vector3;
use a05_lighting::SingleColor;
use common::Color;

use super::{LEFT, RIGHT, UP, assert_close, lambert, light, phong, seen_from, white_from};

#[test]
fn a_single_color_uses_no_light() {
    let material = SingleColor::new(Color::MAGENTA).unwrap();
    let lighting = light(Color::WHITE, &[(Color::WHITE, UP)]);
    assert_eq!(seen_from(LEFT, &material, &lighting), Color::MAGENTA);
}

#[test]
fn a_matt_surface_shows_the_cosine_of_the_light_to_every_eye() {
    let (half, root) = (0.5, 0.75_f64.sqrt());
    for (direction, expected) in [
        (UP, 1.0),
        (RIGHT, 0.8),
        (Vector3::new(0.0, root, half), root),
        (Vector3::new(root, half, 0.0), half),
        (Vector3::new(1.0, 0.0, 0.0), 0.0),
        (Vector3::new(0.6, -0.8, 0.0), 0.0),
        (-UP, 0.0),
    ] {
        for e in [UP, LEFT, RIGHT, Vector3::new(1.0, 1e-9, 0.0)] {
            let color = seen_from(e, &lambert(Color::WHITE), &white_from(direction));
            assert_eq!(color, Color::gray(expected));
        }
    }
}

/// Ambient light, a light from above, one at a cosine of 0.8, and one from below.
#[test]
fn channels_of_surface_and_light_multiply_and_lights_add_up() {
    let (diffuse, ambient) = (Color::new(0.5, 0.25, 1.0), Color::new(0.5, 1.0, 0.125));
    let lights = [
        (Color::new(1.0, 0.5, 0.25), UP),
        (Color::new(0.0, 2.0, 4.0), RIGHT),
        (Color::WHITE, -UP),
    ];
    for (lights, expected) in [
        (&lights[..0], Color::new(0.25, 0.25, 0.125)),
        (&lights[..1], Color::new(0.75, 0.375, 0.375)),
        (&lights[..], Color::new(0.75, 0.775, 3.575)),
    ] {
        let lighting = light(ambient, lights);
        assert_close(seen_from(UP, &lambert(diffuse), &lighting), expected);
        let dull = phong(diffuse, Color::BLACK, 64.0);
        assert_close(seen_from(UP, &dull, &lighting), expected);
    }
}
