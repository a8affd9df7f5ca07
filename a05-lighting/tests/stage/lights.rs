//! Lights: from where, how far and whether at all they shine on a point.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a05_lighting::{DirectionalLight, Illumination, Light, PointLight, SpotLight};
use approx::assert_abs_diff_eq;
use common::{ArgumentError, Color};

const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
const ORANGE: Color = Color::new(1.0, 0.5, 0.0);
/// Rounding of a direction of length 1.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn point_light(x: f64, y: f64, z: f64) -> PointLight {
    PointLight::new(ORANGE, Point3::new(x, y, z)).unwrap()
}

/// At the origin.
fn spot(direction: Vector3, half_angle: f64) -> SpotLight {
    SpotLight::new(ORANGE, Point3::ORIGIN, direction, half_angle).unwrap()
}

#[test]
fn a_point_light_shines_from_its_place_in_all_directions() {
    let light = point_light(2.0, 4.0, 4.0);
    let Illumination {
        color,
        direction,
        distance,
    } = light.illumination(Point3::ORIGIN).unwrap();
    assert_eq!((color, distance), (ORANGE, 6.0));
    let third = Vector3::new(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
    assert_abs_diff_eq!(direction, third, epsilon = ROUNDING);
    assert_eq!(light.direction_from(Point3::ORIGIN), Some(direction));
    for (x, towards) in [(1e100, -1.0), (3.0, -1.0), (1.0, 1.0), (-1e100, 1.0)] {
        let point = Point3::new(x, 4.0, 4.0);
        let direction = light.direction_from(point).unwrap();
        assert_abs_diff_eq!(direction.x(), towards, epsilon = ROUNDING);
        assert!(light.illuminates(point));
    }
}

/// There is no direction from a point to itself: no light, instead of NaN.
#[test]
fn a_light_does_not_shine_on_its_own_place() {
    let place = Point3::new(2.0, 4.0, 4.0);
    let point: &dyn Light = &point_light(2.0, 4.0, 4.0);
    let spot: &dyn Light = &SpotLight::new(ORANGE, place, DOWN, PI).unwrap();
    for light in [point, spot] {
        assert_eq!(light.illumination(place), None);
        assert_eq!(light.direction_from(place), None);
        assert!(!light.illuminates(place));
        let beside = Point3::new(2.0, 4.0_f64.next_up(), 4.0);
        assert_eq!(light.direction_from(beside), Some(DOWN));
    }
}

#[test]
fn a_directional_light_shines_everywhere_from_the_same_side() {
    for length in [1e-200, 1.0, 1e200] {
        let light = DirectionalLight::new(ORANGE, DOWN * length).unwrap();
        let expected = Illumination {
            color: ORANGE,
            direction: -DOWN,
            distance: f64::INFINITY,
        };
        for point in [
            Point3::ORIGIN,
            Point3::new(1e100, 0.0, -1e100),
            Point3::new(0.0, -5.0, 0.0),
        ] {
            assert_eq!(light.illumination(point), Some(expected));
        }
    }
}

/// In its cone a spot light is a point light.
#[test]
fn a_spot_light_shines_along_its_axis_like_a_point_light() {
    let place = Point3::new(2.0, 4.0, 4.0);
    let axis = Point3::ORIGIN - place;
    for half_angle in [1e-7, 0.1, FRAC_PI_2, PI] {
        let light = SpotLight::new(ORANGE, place, axis, half_angle).unwrap();
        let expected = point_light(2.0, 4.0, 4.0).illumination(Point3::ORIGIN);
        assert_eq!(light.illumination(Point3::ORIGIN), expected);
    }
}

/// A billionth of a radian on either side of the rim, which rounding (a few
/// 1e-16) cannot confuse at these angles.
#[test]
fn a_spot_light_ends_at_its_half_angle() {
    for half_angle in [0.1, FRAC_PI_3, FRAC_PI_2, 2.0, 3.0] {
        let light = spot(DOWN * 3.0, half_angle);
        for turn in [0.0, 1.0, 2.5, 4.0] {
            let at = |angle: f64| {
                let (across, along) = (libm::sin(angle), libm::cos(angle));
                let (x, z) = (across * libm::cos(turn), across * libm::sin(turn));
                Point3::new(7.0 * x, -7.0 * along, 7.0 * z)
            };
            assert!(light.illuminates(at(half_angle - 1e-9)));
            assert!(!light.illuminates(at(half_angle + 1e-9)));
        }
    }
}

/// The arc cosine sees no angle below 1.5e-8, and 1e-7 only roughly.
#[test]
fn the_narrowest_beam_is_still_a_beam() {
    let light = spot(DOWN, 1e-7);
    for (beside, lit) in [(0.5e-7, true), (2e-7, false), (1e-6, false)] {
        assert_eq!(light.illuminates(Point3::new(beside, -1.0, 0.0)), lit);
    }
}

#[test]
fn a_half_angle_of_pi_lights_everything() {
    for n in 0..10_000 {
        let direction = direction(n);
        let light = spot(direction, PI);
        assert!(light.illuminates(Point3::ORIGIN - direction));
        assert!(light.illuminates(Point3::ORIGIN + direction * 1e-9));
    }
}

/// Of two parallel vectors of length 1 the rounded product is as often above 1
/// as below. Neither may darken the axis or light the place behind the light.
#[test]
fn points_behind_are_dark_and_points_on_the_axis_are_lit() {
    let (mut behind, mut on_axis) = (0, 0);
    for n in 0..100_000 {
        let direction = direction(n);
        let distance = 1000.0 * PixelRandom::new(6, n, 1).uniform(0) + 1e-3;
        let half_angle = [1e-7, 0.1, FRAC_PI_2, PI - 1e-7][n as usize % 4];
        let light = spot(direction, half_angle);
        behind += u32::from(light.illuminates(Point3::ORIGIN - direction * distance));
        on_axis += u32::from(light.illuminates(Point3::ORIGIN + direction * distance));
    }
    assert_eq!((behind, on_axis), (0, 100_000));
}

/// Of random direction and length.
fn direction(n: u32) -> Vector3 {
    let random = PixelRandom::new(6, n, 0);
    let components = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
    Vector3::from_glam(components.into()) * (1.0 + 9.0 * random.uniform(3))
}

fn refusal<T: std::fmt::Debug>(light: Result<T, ArgumentError>) -> String {
    light.unwrap_err().to_string()
}

#[test]
fn bad_colors_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, -0.5, 1e51] {
        let color = Color::new(1.0, bad, 1.0);
        for said in [
            refusal(PointLight::new(color, Point3::ORIGIN)),
            refusal(DirectionalLight::new(color, DOWN)),
            refusal(SpotLight::new(color, Point3::ORIGIN, DOWN, 1.0)),
        ] {
            assert!(said.starts_with("light colour is"), "{said}");
            assert!(said.contains("channels from 0 to 1e50"), "{said}");
        }
    }
    assert!(PointLight::new(Color::gray(50.0), Point3::ORIGIN).is_ok());
}

#[test]
fn bad_positions_and_directions_are_refused_by_name() {
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        let place = Point3::new(0.0, 0.0, bad);
        for said in [
            refusal(PointLight::new(ORANGE, place)),
            refusal(SpotLight::new(ORANGE, place, DOWN, 1.0)),
        ] {
            assert!(said.starts_with("light position is"), "{said}");
            assert!(said.contains("from -1e100 to 1e100"), "{said}");
        }
    }
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let direction = Vector3::new(0.0, bad, 0.0);
        for said in [
            refusal(DirectionalLight::new(ORANGE, direction)),
            refusal(SpotLight::new(ORANGE, Point3::ORIGIN, direction, 1.0)),
        ] {
            assert!(said.starts_with("light direction is"), "{said}");
            assert!(said.contains("not all of them 0"), "{said}");
        }
    }
}

#[test]
fn bad_half_angles_are_refused_by_name() {
    for bad in [0.0, -1.0, 0.99e-7, PI.next_up(), f64::NAN, f64::INFINITY] {
        let said = refusal(SpotLight::new(ORANGE, Point3::ORIGIN, DOWN, bad));
        assert!(said.starts_with("half angle is"), "{said}");
        assert!(said.contains("radians from 1e-7 to pi"), "{said}");
    }
}
