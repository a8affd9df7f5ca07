//! Materials and lights together in a world.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Plane, Sphere};
use a05_lighting::{DirectionalLight, LitWorld, PointLight};
use common::Color;

use super::{UP, assert_close, lambert, phong};

fn empty() -> LitWorld {
    LitWorld::new(Color::BLUE, Color::gray(0.25)).unwrap()
}

fn floor() -> Plane {
    Plane::new(Point3::ORIGIN, UP.as_normal()).unwrap()
}

#[test]
fn a_lit_world_shades_the_nearest_object_with_all_its_lights() {
    let world = empty()
        .with(floor(), Box::new(lambert(Color::WHITE)))
        .lit_by(Box::new(DirectionalLight::new(Color::RED, -UP).unwrap()))
        .lit_by(Box::new(
            PointLight::new(Color::GREEN, Point3::new(3.0, 4.0, 0.0)).unwrap(),
        ));
    let down = Ray::new(Point3::new(0.0, 2.0, 0.0), -UP).unwrap();
    assert_close(world.color_for(&down), Color::new(1.25, 1.05, 0.25));
    let up = Ray::new(Point3::new(0.0, 2.0, 0.0), UP).unwrap();
    assert_eq!(world.color_for(&up), Color::BLUE);
    assert_eq!(world.ambient(), Color::gray(0.25));
    assert_eq!(world.objects().background(), Color::BLUE);
    assert_eq!(world.lights().len(), 2);
}

/// Lights under the floor, in its plane, and exactly where the ray meets it.
#[test]
fn lights_behind_a_surface_leave_the_ambient_light() {
    for y in [-1.0, -1e-9, 0.0] {
        for x in [0.0, 2.0] {
            let light = PointLight::new(Color::WHITE, Point3::new(x, y, 0.0)).unwrap();
            let world = empty()
                .with(floor(), Box::new(phong(Color::WHITE, Color::WHITE, 0.0)))
                .lit_by(Box::new(light));
            let down = Ray::new(Point3::new(0.0, 2.0, 0.0), -UP).unwrap();
            assert_eq!(world.color_for(&down), Color::gray(0.25));
        }
    }
}

/// Camera and light in the centre: `n · l = 1` everywhere.
#[test]
fn a_sphere_is_lit_from_inside() {
    let c = Point3::new(1.0, -2.0, 3.0);
    let world = LitWorld::new(Color::BLACK, Color::BLACK)
        .unwrap()
        .with(
            Sphere::new(c, 2.0).unwrap(),
            Box::new(lambert(Color::WHITE)),
        )
        .lit_by(Box::new(PointLight::new(Color::WHITE, c).unwrap()));
    for n in 0..1000 {
        let random = PixelRandom::new(10, n, 0);
        let d = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
        let ray = Ray::new(c, Vector3::from_glam(d.into())).unwrap();
        assert_close(world.color_for(&ray), Color::WHITE);
    }
}
