//! The shadows of each kind of light.

use std::f64::consts::FRAC_PI_4;

use a02_math::Point3;
use a05_lighting::{DirectionalLight, Light, PointLight, SpotLight};
use a06_shadows_reflection::{LightSource, ShadowedWorld};
use common::Color;

use super::{AMBIENT, LIT, UP, floor, lamp, point_light, seen, sphere, white};

#[test]
fn a_light_without_shadows_shines_through_everything() {
    let through = LightSource::new(point_light(0.0, 6.0, 0.0), false);
    assert!(!through.casts_shadows());
    assert!(lamp(point_light(0.0, 6.0, 0.0)).casts_shadows());
    let world = floor()
        .with(sphere(0.0, 3.0, 0.0, 1.0), white())
        .lit_by(through);
    assert_eq!(seen(&world), LIT);
}

/// The source answers for the light in it, shadows or not.
#[test]
fn a_light_source_is_the_light_it_holds() {
    let light = point_light(0.0, 6.0, 0.0);
    for casts_shadows in [true, false] {
        let source = LightSource::new(light, casts_shadows);
        for point in [Point3::ORIGIN, Point3::new(0.0, 6.0, 0.0)] {
            assert_eq!(source.illumination(point), light.illumination(point));
            assert_eq!(source.illuminates(point), light.illuminates(point));
        }
    }
}

#[test]
fn each_light_has_its_own_shadow() {
    let lights = |world: ShadowedWorld| {
        world
            .lit_by(lamp(
                PointLight::new(Color::RED, Point3::new(0.0, 6.0, 0.0)).unwrap(),
            ))
            .lit_by(lamp(DirectionalLight::new(Color::GREEN, -UP).unwrap()))
            .lit_by(LightSource::new(
                DirectionalLight::new(Color::BLUE, -UP).unwrap(),
                false,
            ))
    };
    for (y, expected) in [
        (3.0, Color::BLUE),
        (9.0, Color::MAGENTA),
        (-3.0, Color::WHITE),
    ] {
        let world = lights(floor().with(sphere(0.0, y, 0.0, 1.0), white()));
        assert_eq!(seen(&world), AMBIENT + expected);
    }
}

#[test]
fn spot_and_directional_lights_cast_shadows_too() {
    let spot = SpotLight::new(Color::WHITE, Point3::new(0.0, 6.0, 0.0), -UP, FRAC_PI_4);
    let sun = DirectionalLight::new(Color::WHITE, -UP).unwrap();
    let [bright_spot, bright_sun, dark_spot, dark_sun, far_sun] = [
        floor().lit_by(lamp(spot.clone().unwrap())),
        floor().lit_by(lamp(sun)),
        floor()
            .with(sphere(0.0, 3.0, 0.0, 1.0), white())
            .lit_by(lamp(spot.clone().unwrap())),
        floor()
            .with(sphere(0.0, 3.0, 0.0, 1.0), white())
            .lit_by(lamp(sun)),
        // However far away.
        floor()
            .with(sphere(0.0, 1e12, 0.0, 1.0), white())
            .lit_by(lamp(sun)),
    ]
    .map(|world| seen(&world));
    assert_eq!((bright_spot, bright_sun), (LIT, LIT));
    assert_eq!((dark_spot, dark_sun, far_sun), (AMBIENT, AMBIENT, AMBIENT));
    // Beside the cone nothing needs to be in the way.
    let beside = floor().lit_by(lamp(
        SpotLight::new(Color::WHITE, Point3::new(7.0, 6.0, 0.0), -UP, FRAC_PI_4).unwrap(),
    ));
    assert_eq!(seen(&beside), AMBIENT);
}

/// Much closer than any fixed length that a shadow ray might skip.
#[test]
fn a_light_just_above_a_surface_lights_it() {
    for height in [1e-3, 1e-6, 1e-9] {
        let world = floor().lit_by(lamp(point_light(0.0, height, 0.0)));
        assert_eq!(seen(&world), LIT, "at {height}");
    }
}
