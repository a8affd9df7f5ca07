//! Shadows: the shapes and lights that cast one, and those that do not. Spot lights, and
//! lights in a surface and just above it, are the extreme cases I01 to I18.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Light, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, Surface};
use approx::assert_abs_diff_eq;
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AMBIENT: Color = Color::gray(0.25);

fn white() -> Box<dyn Surface> {
    Box::new(Lambert::new(Color::WHITE).unwrap())
}

fn plane(y: f64) -> Plane {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal()).unwrap()
}

fn sphere(x: f64, y: f64, r: f64) -> Sphere {
    Sphere::new(Point3::new(x, y, 0.0), r).unwrap()
}

fn point_light(color: Color, y: f64) -> PointLight {
    PointLight::new(color, Point3::new(0.0, y, 0.0)).unwrap()
}

/// The white floor y = 0 in a little ambient light, with one more object.
fn floor(object: impl Geometry) -> ShadowedWorld {
    ShadowedWorld::empty(Color::BLACK, AMBIENT)
        .unwrap()
        .with(plane(0.0), white())
        .with(object, white())
}

fn casting(light: impl Light) -> LightSource {
    LightSource::new(light, true)
}

/// The colour of the origin, seen from far enough aside that no object above it is in
/// the way.
fn seen(world: &ShadowedWorld) -> Color {
    let eye = Point3::new(-8.0, 1.0, 0.0);
    let ray = Ray::new(eye, Point3::ORIGIN - eye).unwrap();
    RecursiveTracer::new(world).trace(&ray, 1)
}

/// The colour of the origin on a floor with this object, under a lamp at a height of 6.
fn under_lamp(object: impl Geometry) -> Color {
    let lamp = casting(point_light(Color::WHITE, 6.0));
    seen(&floor(object).lit_by(lamp))
}

#[test]
fn every_shape_before_a_light_casts_a_shadow_from_both_sides() {
    let (lbf, run) = (Point3::new(-1.0, 2.0, -1.0), Point3::new(1.0, 3.0, 1.0));
    let [a, b, c] = [(-1.0, -1.0), (2.0, -1.0), (0.0, 2.0)].map(|(x, z)| Point3::new(x, 2.0, z));
    for color in [
        under_lamp(AxisAlignedBox::new(lbf, run).unwrap()),
        under_lamp(Triangle::new(a, b, c).unwrap()),
        under_lamp(Triangle::new(a, c, b).unwrap()),
        under_lamp(plane(2.0)),
        under_lamp(sphere(0.0, 6.0, 2.0)),
    ] {
        assert_eq!(color, AMBIENT);
    }
    for (y, r) in [(1.5, 1.0), (4.0, 1.0), (1.5, 1e-9), (4.0, 1e-9)] {
        assert_eq!(under_lamp(sphere(0.0, y, r)), AMBIENT, "{r} at {y}");
    }
}

/// Below the red lamp, above it, and below the floor: the green light has no distance, and
/// the blue one casts no shadows.
#[test]
fn each_light_has_its_own_shadow() {
    let sun = |color| DirectionalLight::new(color, -UP).unwrap();
    for (y, expected) in [
        (3.0, Color::BLUE),
        (9.0, Color::MAGENTA),
        (1e12, Color::MAGENTA),
        (-3.0, Color::WHITE),
    ] {
        let world = floor(sphere(0.0, y, 1.0))
            .lit_by(casting(point_light(Color::RED, 6.0)))
            .lit_by(casting(sun(Color::GREEN)))
            .lit_by(LightSource::new(sun(Color::BLUE), false));
        assert_eq!(seen(&world), AMBIENT + expected);
    }
}

/// A lamp that is fixed to the ceiling: it lies in the object, and lights the
/// room all the same, from every point of view and at every height of the ceiling.
/// A ceiling a millionth lower hides the lamp.
///
/// Tolerance: the eye looks at a slope of 0.3 / 1000 at most, so that the place
/// it sees is wrong by up to 1e4 eps of its distance, and the cosine by as much
/// relative to the height: 1e7 eps.
#[test]
fn an_object_at_the_light_itself_is_not_in_its_way() {
    for height in [1e-3, 1.0, 1e3] {
        for distance in [1.0, 30.0, 1e3] {
            for (x, z) in [
                (0.0, 0.0),
                (0.3, -0.7),
                (-1.0, 0.1),
                (5.0, 0.0),
                (-9.0, 30.0),
            ] {
                // The eye is below the ceiling, and looks at the floor aslant.
                let place = Point3::new(x, 0.0, z).to_glam() * height;
                let way = Vector3::new(0.6 * distance, 0.3, -0.8 * distance) * height;
                let ray = Ray::new(Point3::from_glam(place) + way, -way).unwrap();
                let cosine = 1.0 / (1.0 + x * x + z * z).sqrt();
                for (ceiling, lit) in [(1.0, cosine), (1.0 - 1e-6, 0.0)] {
                    let lamp = casting(point_light(Color::WHITE, height));
                    let world = floor(plane(ceiling * height)).lit_by(lamp);
                    let color = RecursiveTracer::new(&world).trace(&ray, 1);
                    assert_abs_diff_eq!(color.r, 0.25 + lit, epsilon = 1e7 * f64::EPSILON);
                }
            }
        }
    }
}
