//! Each light has its own shadow. Lamps in surfaces, just above them and on the ceiling are
//! the extreme cases I01 to I18, rays that leave a surface the experiment `acne`, and the shapes that
//! cast a shadow are compared in random worlds.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Plane, Sphere};
use a05_lighting::{DirectionalLight, Lambert, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, Surface};
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// Below the red lamp, just below, touching it from above, above, and below the floor: the
/// green light has no distance, and the blue one casts no shadows. The eye is aside, so that
/// no ball is in its way.
#[test]
fn each_light_has_its_own_shadow() {
    let white = || -> Box<dyn Surface> { Box::new(Lambert::new(Color::WHITE).unwrap()) };
    let sun = |color| DirectionalLight::new(color, -UP).unwrap();
    for (y, r, expected) in [
        (3.0, 1.0, Color::BLUE),
        (6.0 - 3e-6, 1e-6, Color::BLUE),
        (7.0, 1.0, Color::MAGENTA),
        (1e12, 1.0, Color::MAGENTA),
        (-3.0, 1.0, Color::WHITE),
    ] {
        let ambient = Color::gray(0.25);
        let floor = Plane::new(Point3::ORIGIN, UP.as_normal()).unwrap();
        let above = |y| Point3::new(0.0, y, 0.0);
        let lamp = PointLight::new(Color::RED, above(6.0)).unwrap();
        let world = ShadowedWorld::empty(Color::BLACK, ambient)
            .unwrap()
            .with(floor, white())
            .with(Sphere::new(above(y), r).unwrap(), white())
            .lit_by(LightSource::new(lamp, true))
            .lit_by(LightSource::new(sun(Color::GREEN), true))
            .lit_by(LightSource::new(sun(Color::BLUE), false));
        let eye = Vector3::new(-8.0, 1.0, 0.0);
        let ray = Ray::new(Point3::ORIGIN + eye, -eye).unwrap();
        let color = RecursiveTracer::new(&world).trace(&ray, 1);
        assert_eq!(color, ambient + expected);
    }
}
