//! Materials and lights together in a world.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Plane;
use a05_lighting::{DirectionalLight, Lambert, LitWorld, PointLight};
use approx::assert_abs_diff_eq;
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The directional light comes from above, the point light from (3, 4, 0): 0.8 of it, by
/// the triangle of sides 3, 4 and 5.
#[test]
fn a_lit_world_shades_the_nearest_object_with_all_its_lights() {
    let floor = Plane::new(Point3::ORIGIN, UP.as_normal()).unwrap();
    let sun = DirectionalLight::new(Color::RED, -UP).unwrap();
    let lamp = PointLight::new(Color::GREEN, Point3::new(3.0, 4.0, 0.0)).unwrap();
    let world = LitWorld::new(Color::BLUE, Color::gray(0.25))
        .unwrap()
        .with(floor, Box::new(Lambert::new(Color::WHITE).unwrap()))
        .lit_by(Box::new(sun))
        .lit_by(Box::new(lamp));
    let color = |d| world.color_for(&Ray::derived(Point3::ORIGIN + UP * 2.0, d));
    let expected = Color::new(1.25, 1.05, 0.25);
    for (channel, expected) in color(-UP).channels().into_iter().zip(expected.channels()) {
        assert_abs_diff_eq!(channel, expected, epsilon = 8.0 * f64::EPSILON);
    }
    assert_eq!(color(UP), Color::BLUE);
}
