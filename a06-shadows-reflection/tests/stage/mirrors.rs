//! Mirrors: mirror images, and surfaces that do not mirror. Two mirrors that face each
//! other, and mirrors under several lights, are the extreme cases M01 to M19; depth and
//! background are the exercise `mirror`.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Phong, SingleColor};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use common::Color;
use testing::assert_refused;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const X: Vector3 = Vector3::new(1.0, 0.0, 0.0);
const WHITE: Color = Color::WHITE;
const BLACK: Color = Color::BLACK;

/// A matt surface of this diffuse colour that also reflects.
fn mirror(diffuse: Color, reflection: Color) -> Box<dyn Surface> {
    Box::new(Reflective::new(diffuse, BLACK, 64.0, reflection).unwrap())
}

fn world(background: Color, ambient: Color) -> ShadowedWorld {
    ShadowedWorld::empty(background, ambient).unwrap()
}

fn plane(through: Point3, n: Vector3) -> Plane {
    Plane::new(through, n.as_normal()).unwrap()
}

fn floor() -> Plane {
    plane(Point3::ORIGIN, UP)
}

fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}

fn from_above(direction: Vector3) -> Ray {
    Ray::new(Point3::new(0.0, 3.0, 0.0), direction).unwrap()
}

/// A plane mirror shows the view of an eye behind it, without the mirror.
#[test]
fn a_plane_mirror_shows_the_mirrored_scene() {
    let gray = Color::gray(0.5);
    let balls = || {
        let colors = [Color::RED, Color::GREEN, Color::BLUE, Color::YELLOW];
        (0..4).fold(world(gray, BLACK), |world, n| {
            let x = f64::from(n) * 1.7 - 2.5;
            let ball = Sphere::new(Point3::new(x, 1.5 + 0.3 * x, 0.4 * x), 0.8).unwrap();
            let color = SingleColor::new(colors[n as usize]).unwrap();
            world.with(ball, Box::new(color))
        })
    };
    let (without, with_mirror) = (balls(), balls().with(floor(), mirror(BLACK, WHITE)));
    let mut seen = std::collections::HashSet::new();
    for n in 0..5000 {
        let random = PixelRandom::new(13, n, 0);
        let [x, z] = [0, 1].map(|i| 12.0 * random.uniform(i) - 6.0);
        let place = Point3::new(x, 0.0, z);
        let [ray, mirrored] = [2.0, -2.0].map(|y| {
            let eye = Point3::new(0.5, y, 9.0);
            Ray::new(eye, place - eye).unwrap()
        });
        // Otherwise a ball stands before the mirror, or below it.
        if trace(&without, &ray, 1) == gray {
            let color = trace(&with_mirror, &ray, 2);
            assert_eq!(color, trace(&without, &mirrored, 1), "at {place:?}");
            seen.insert(color.to_bytes());
        }
    }
    assert_eq!(seen.len(), 5, "all balls and the background");
}

/// The normal leans by 30 degrees, so that a ray straight from above is reflected at
/// 60 degrees, to a small ball. By the normal of the face it would go back up.
#[test]
fn a_curved_triangle_reflects_on_its_interpolated_normal() {
    let leaning = Vector3::new(0.5, 0.75_f64.sqrt(), 0.0).as_normal();
    let [a, b, c] = [(-1.0, 1.0), (1.0, 1.0), (0.0, -2.0)].map(|(x, z)| Point3::new(x, 0.0, z));
    let triangle = Triangle::new(a, b, c).unwrap().with_normals([leaning; 3]);
    let ball = Sphere::new(Point3::new(5.0 * 0.75_f64.sqrt(), 2.5, 0.0), 0.01).unwrap();
    let world = world(BLACK, BLACK)
        .with(triangle.unwrap(), mirror(BLACK, WHITE))
        .with(ball, Box::new(SingleColor::new(Color::GREEN).unwrap()));
    assert_eq!(trace(&world, &from_above(-UP), 2), Color::GREEN);
}

/// In its own light a mirror is the shiny surface under it; other surfaces do not mirror.
#[test]
fn only_reflective_surfaces_mirror() {
    let (diffuse, specular) = (Color::new(0.2, 0.4, 0.6), Color::gray(0.5));
    let tinted = Color::new(0.0, 0.5, 1.0);
    let color = |surface: Box<dyn Surface>, reflection: Color| {
        assert_eq!(surface.reflection(), reflection);
        let sun = DirectionalLight::new(WHITE, -UP).unwrap();
        let world = world(BLACK, Color::gray(0.25)).with(floor(), surface);
        trace(
            &world.lit_by(LightSource::new(sun, true)),
            &from_above(X - UP * 3.0),
            1,
        )
    };
    let shiny = Phong::new(diffuse, specular, 8.0).unwrap();
    let reflective = Reflective::new(diffuse, specular, 8.0, tinted).unwrap();
    assert_eq!(
        color(Box::new(reflective), tinted),
        color(Box::new(shiny), BLACK)
    );
    color(Box::new(SingleColor::new(WHITE).unwrap()), BLACK);
    color(Box::new(Lambert::new(WHITE).unwrap()), BLACK);
}

#[test]
fn bad_arguments_are_refused_by_name() {
    for number in [f64::NAN, f64::INFINITY, -0.5, 1.0_f64.next_up()] {
        let reflective = Reflective::new(WHITE, WHITE, 1.0, Color::new(1.0, number, 1.0));
        assert_refused(reflective, "reflection is", "from 0 to 1");
    }
    let bad = Color::new(1.0, f64::NAN, 1.0);
    let allowed = "channels from 0 to 1e50";
    let diffuse = Reflective::new(bad, WHITE, 1.0, WHITE);
    assert_refused(diffuse, "diffuse is", allowed);
    let specular = Reflective::new(WHITE, bad, 1.0, WHITE);
    assert_refused(specular, "specular is", allowed);
    let exponent = Reflective::new(WHITE, WHITE, -0.5, WHITE);
    assert_refused(exponent, "exponent is", "at least 0");
}
