//! Lights in their own place, and points straight before and behind a spot light. Rims of
//! beams, and lights far away, are the extreme cases F06 to F38 and I07 to I25; the formulas
//! of all lights, the exercises.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a05_lighting::{Light, PointLight, SpotLight};
use common::Color;

const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
const PLACE: Point3 = Point3::new(2.0, 4.0, 4.0);

/// There is no direction from a point to itself: no light, instead of NaN.
#[test]
fn a_light_does_not_shine_on_its_own_place() {
    let point: &dyn Light = &PointLight::new(Color::WHITE, PLACE).unwrap();
    let spot: &dyn Light = &SpotLight::new(Color::WHITE, PLACE, DOWN, PI).unwrap();
    for light in [point, spot] {
        assert_eq!(light.illumination(PLACE), None);
        assert_eq!(light.direction_from(PLACE), None);
        assert!(!light.illuminates(PLACE));
        let beside = Point3::new(2.0, 4.0_f64.next_up(), 4.0);
        assert_eq!(light.direction_from(beside), Some(DOWN));
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
            let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
            let [ahead, behind] = [way, -way].map(|way| Point3::ORIGIN + way);
            let light = light.unwrap();
            assert!(light.illuminates(ahead));
            let is_lit = light.illuminates(behind);
            assert_eq!(is_lit, half_angle == PI, "{half_angle} {way:?}");
        }
    }
}
