//! Point and spot lights: direction, distance and colour at a point, and points outside of a beam.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a05_lighting::{Illumination, Light, PointLight, SpotLight};
use approx::assert_abs_diff_eq;
use common::Color;

const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
const ORANGE: Color = Color::new(1.0, 0.5, 0.0);
const PLACE: Point3 = Point3::new(2.0, 4.0, 4.0);
/// Rounding of a direction of length 1.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn point_light() -> PointLight {
    PointLight::new(ORANGE, PLACE).unwrap()
}

/// At the origin.
fn spot(direction: Vector3, half_angle: f64) -> SpotLight {
    SpotLight::new(ORANGE, Point3::ORIGIN, direction, half_angle).unwrap()
}

#[test]
fn a_point_light_shines_from_its_place_in_all_directions() {
    let third = Vector3::new(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
    let left = Vector3::new(-1.0, 0.0, 0.0);
    for (point, towards, length) in [
        (Point3::ORIGIN, third, 6.0),
        (Point3::new(1e100, 4.0, 4.0), left, 1e100),
        (Point3::new(3.0, 4.0, 4.0), left, 1.0),
        (Point3::new(1.0, 4.0, 4.0), -left, 1.0),
    ] {
        let Illumination {
            color,
            direction,
            distance,
        } = point_light().illumination(point).unwrap();
        assert_eq!((color, distance), (ORANGE, length));
        assert_abs_diff_eq!(direction, towards, epsilon = ROUNDING);
        assert!(point_light().illuminates(point));
        assert_eq!(point_light().direction_from(point), Some(direction));
    }
}

/// There is no direction from a point to itself: no light, instead of NaN.
#[test]
fn a_light_does_not_shine_on_its_own_place() {
    let point: &dyn Light = &point_light();
    let spot: &dyn Light = &SpotLight::new(ORANGE, PLACE, DOWN, PI).unwrap();
    for light in [point, spot] {
        assert_eq!(light.illumination(PLACE), None);
        assert_eq!(light.direction_from(PLACE), None);
        assert!(!light.illuminates(PLACE));
        let beside = Point3::new(2.0, 4.0_f64.next_up(), 4.0);
        assert_eq!(light.direction_from(beside), Some(DOWN));
    }
}

/// In its cone a spot light is a point light. Rounding (a few 1e-16) cannot confuse angles
/// a billionth beside the rim, nor, in the narrowest beam, half of it; there the arc
/// cosine sees no angle below 1.5e-8.
#[test]
fn a_spot_light_shines_up_to_its_half_angle() {
    let axis = Point3::ORIGIN - PLACE;
    for half_angle in [1e-7, 0.1, FRAC_PI_3, FRAC_PI_2, 2.0, 3.0] {
        let light = SpotLight::new(ORANGE, PLACE, axis, half_angle).unwrap();
        let expected = point_light().illumination(Point3::ORIGIN);
        assert_eq!(light.illumination(Point3::ORIGIN), expected);

        let light = spot(DOWN * 3.0, half_angle);
        let margin = if half_angle < 1e-6 { 0.5e-7 } else { 1e-9 };
        for turn in [0.0, 1.0, 2.5, 4.0] {
            let at = |angle: f64| {
                let (across, along) = (libm::sin(angle), libm::cos(angle));
                let (x, z) = (across * libm::cos(turn), across * libm::sin(turn));
                Point3::new(7.0 * x, -7.0 * along, 7.0 * z)
            };
            assert!(light.illuminates(at(half_angle - margin)));
            assert!(!light.illuminates(at(half_angle + margin)));
        }
    }
}

/// Of two parallel vectors of length 1 the rounded product is as often above 1
/// as below. Neither may darken the axis or light the place behind the light.
#[test]
fn rounding_neither_darkens_the_axis_nor_lights_the_far_side() {
    for n in 0..20_000 {
        let random = PixelRandom::new(6, n, 0);
        let components = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
        let direction = Vector3::from_glam(components.into()) * (1.0 + 9.0 * random.uniform(3));
        let way = direction * (1000.0 * random.uniform(4) + 1e-3);
        for half_angle in [1e-7, 0.1, FRAC_PI_2, PI - 1e-7, PI] {
            let light = spot(direction, half_angle);
            let is_behind_lit = light.illuminates(Point3::ORIGIN - way);
            assert!(light.illuminates(Point3::ORIGIN + way));
            assert_eq!(is_behind_lit, half_angle == PI, "{half_angle} {way:?}");
        }
    }
}
