//! Matt surfaces, and surfaces of a single colour.

use a02_math::Vector3;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lighting, SingleColor};
use common::Color;

use super::{Given, LEFT, RIGHT, UP, assert_close, lambert, light_from, phong, seen_from};

struct NobodyMayAsk;

impl Lighting for NobodyMayAsk {
    fn ambient(&self) -> Color {
        panic!("asked for the ambient light")
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, _: &mut dyn FnMut(&Illumination)) {
        panic!("asked for the lights")
    }
}

#[test]
fn a_single_color_asks_for_no_light() {
    let material = SingleColor::new(Color::MAGENTA).unwrap();
    assert_eq!(seen_from(LEFT, &material, &NobodyMayAsk), Color::MAGENTA);
}

#[test]
fn a_matt_surface_dims_with_the_cosine_of_the_light() {
    let material = lambert(Color::WHITE);
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
        let color = seen_from(UP, &material, &light_from(&[(Color::WHITE, direction)]));
        assert_eq!(color, Color::gray(expected));
    }
}

#[test]
fn channels_of_surface_and_light_multiply_and_lights_add_up() {
    let material = lambert(Color::new(0.5, 0.25, 1.0));
    let lighting = Given {
        ambient: Color::new(0.5, 1.0, 0.125),
        ..light_from(&[
            (Color::new(1.0, 0.5, 0.25), UP),
            (Color::new(0.0, 2.0, 4.0), RIGHT),
            (Color::WHITE, -UP),
        ])
    };
    // Ambient, and 1 times and 0.8 times a light.
    let expected = Color::new(
        0.25 + 0.5,
        0.25 + 0.125 + 0.8 * 0.5,
        0.125 + 0.25 + 0.8 * 4.0,
    );
    assert_close(seen_from(UP, &material, &lighting), expected);
}

#[test]
fn a_matt_surface_looks_the_same_from_everywhere() {
    let (material, lighting) = (lambert(Color::RED), light_from(&[(Color::WHITE, RIGHT)]));
    let expected = seen_from(UP, &material, &lighting);
    for e in [LEFT, RIGHT, Vector3::new(1.0, 1e-9, 0.0)] {
        assert_eq!(seen_from(e, &material, &lighting), expected);
    }
}

#[test]
fn without_lights_the_ambient_light_is_left() {
    let lighting = Given {
        ambient: Color::gray(0.25),
        ..light_from(&[])
    };
    let diffuse = Color::new(0.5, 1.0, 0.0);
    let expected = Color::new(0.125, 0.25, 0.0);
    let shiny = phong(diffuse, Color::WHITE, 64.0);
    assert_eq!(seen_from(UP, &lambert(diffuse), &lighting), expected);
    assert_eq!(seen_from(UP, &shiny, &lighting), expected);
}
