//! Arguments that lights and materials refuse.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a05_lighting::{
    DirectionalLight, Lambert, LitWorld, Phong, PointLight, SingleColor, SpotLight,
};
use common::Color;
use testing::assert_refused;

const WHITE: Color = Color::WHITE;
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
const O: Point3 = Point3::ORIGIN;

#[test]
fn bad_colors_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, -1e-9, 1e51] {
        let color = Color::new(1.0, bad, 1.0);
        let allowed = "channels from 0 to 1e50";
        assert_refused(PointLight::new(color, O), "light colour is", allowed);
        let sun = DirectionalLight::new(color, DOWN);
        assert_refused(sun, "light colour is", allowed);
        let spot = SpotLight::new(color, O, DOWN, 1.0);
        assert_refused(spot, "light colour is", allowed);
        assert_refused(SingleColor::new(color), "colour is", allowed);
        assert_refused(Lambert::new(color), "diffuse is", allowed);
        assert_refused(Phong::new(color, WHITE, 1.0), "diffuse is", allowed);
        assert_refused(Phong::new(WHITE, color, 1.0), "specular is", allowed);
        assert_refused(LitWorld::new(color, WHITE), "background is", allowed);
        assert_refused(LitWorld::new(WHITE, color), "ambient light is", allowed);
    }
}

#[test]
fn bad_positions_directions_and_numbers_are_refused_by_name() {
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        let (place, allowed) = (Point3::new(0.0, 0.0, bad), "from -1e100 to 1e100");
        assert_refused(PointLight::new(WHITE, place), "light position is", allowed);
        let spot = SpotLight::new(WHITE, place, DOWN, 1.0);
        assert_refused(spot, "light position is", allowed);
    }
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let (direction, name) = (Vector3::new(0.0, bad, 0.0), "light direction is");
        let allowed = "not all of them 0";
        assert_refused(DirectionalLight::new(WHITE, direction), name, allowed);
        assert_refused(SpotLight::new(WHITE, O, direction, 1.0), name, allowed);
    }
    for bad in [0.0, -1.0, 0.99e-7, PI.next_up(), f64::NAN, f64::INFINITY] {
        let spot = SpotLight::new(WHITE, O, DOWN, bad);
        assert_refused(spot, "half angle is", "radians from 1e-7 to pi");
    }
    for bad in [-1.0, -1e-300, f64::NAN, f64::INFINITY] {
        let phong = Phong::new(WHITE, WHITE, bad);
        assert_refused(phong, "exponent is", "finite number of at least 0");
    }
}
