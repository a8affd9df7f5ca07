//! Mirror images.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Sphere, Triangle};
use a05_lighting::{DirectionalLight, SingleColor};
use a06_shadows_reflection::LightSource;
use common::Color;

use super::{UP, X, balls, mirror, plane, trace, world};

/// Each mirror takes its share of each channel.
#[test]
fn the_background_is_seen_through_mirrors() {
    let (first, second) = (Color::new(0.5, 1.0, 0.25), Color::new(0.5, 0.0, 0.75));
    // Down to the floor, reflected to the wall, and from there to the sky.
    let corner = world(Color::new(1.0, 1.0, 0.5), Color::BLACK)
        .with(plane(Point3::ORIGIN, UP), mirror(Color::WHITE, first))
        .with(
            plane(Point3::new(4.0, 0.0, 0.0), X),
            mirror(Color::WHITE, second),
        );
    let ray = Ray::new(Point3::new(0.0, 2.0, 0.0), Vector3::new(1.0, -1.0, 0.0)).unwrap();
    let expected = Color::new(0.25, 0.0, 0.09375);
    assert_eq!(trace(&corner, &ray, 3), expected);
    assert_eq!(trace(&corner, &ray, 2), Color::BLACK, "cut off");
}

/// In the sum over the lights, three of them would reflect three times.
#[test]
fn what_is_mirrored_is_added_once_however_many_lights_there_are() {
    let down = Ray::new(Point3::new(0.0, 3.0, 0.0), -UP).unwrap();
    for lights in 0..=3_u32 {
        let floor = world(Color::BLUE, Color::gray(0.25)).with(
            plane(Point3::ORIGIN, UP),
            mirror(Color::WHITE, Color::gray(0.5)),
        );
        let lit = (0..lights).fold(floor, |world, _| {
            let light = DirectionalLight::new(Color::RED, -UP).unwrap();
            world.lit_by(LightSource::new(light, true))
        });
        let expected = Color::new(0.25 + f64::from(lights), 0.25, 0.25 + 0.5);
        assert_eq!(trace(&lit, &down, 5), expected);
    }
}

/// A plane mirror shows the view of an eye behind it, without the mirror.
#[test]
fn a_plane_mirror_shows_the_mirrored_scene() {
    let floor = plane(Point3::ORIGIN, UP);
    let with_mirror = balls(world(Color::gray(0.5), Color::BLACK))
        .with(floor, mirror(Color::BLACK, Color::WHITE));
    let without = balls(world(Color::gray(0.5), Color::BLACK));
    let mut seen = std::collections::HashSet::new();
    for n in 0..5000 {
        let random = PixelRandom::new(13, n, 0);
        let [x, z] = [0, 1].map(|i| 12.0 * random.uniform(i) - 6.0);
        let (eye, place) = (Point3::new(0.5, 2.0, 9.0), Point3::new(x, 0.0, z));
        let (ray, behind) = (place - eye, Point3::new(0.5, -2.0, 9.0));
        let first = Ray::new(eye, ray).unwrap();
        if trace(&without, &first, 1) != Color::gray(0.5) {
            continue; // A ball stands before the mirror, or below it.
        }
        let color = trace(&with_mirror, &first, 2);
        let mirrored = Ray::new(behind, place - behind).unwrap();
        assert_eq!(color, trace(&without, &mirrored, 1), "at {place:?}");
        seen.insert(color.to_bytes());
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
    let world = world(Color::BLACK, Color::BLACK)
        .with(triangle.unwrap(), mirror(Color::BLACK, Color::WHITE))
        .with(ball, Box::new(SingleColor::new(Color::GREEN).unwrap()));
    let down = Ray::new(Point3::new(0.0, 3.0, 0.0), -UP).unwrap();
    assert_eq!(trace(&world, &down, 2), Color::GREEN);
}

/// A convex mirror alone in a white world reflects white everywhere. Where a
/// reflected ray met its own surface again the picture would be black.
#[test]
fn a_convex_mirror_does_not_reflect_itself_at_any_size() {
    for s in [1e-6, 1.0, 1e6, 1e9] {
        let middle = Point3::new(3.0 * s, -2.0 * s, 5.0 * s);
        let eye = middle + Vector3::new(-6.0, 5.0, -4.0) * s;
        let at = |d: f64| middle + Vector3::new(d, -d, d) * s;
        let tilted = Vector3::new(0.3, 1.0, -0.2);
        let hits = [
            count_white(Sphere::new(middle, s).unwrap(), eye, middle, s),
            count_white(
                AxisAlignedBox::new(at(-0.7), at(0.8)).unwrap(),
                eye,
                middle,
                s,
            ),
            count_white(plane(middle, UP), eye, middle, s),
            count_white(plane(middle, tilted), eye, middle, s),
        ];
        assert!(hits.iter().all(|n| *n > 1000), "{hits:?}");
    }
}

/// How many rays meet the mirror, all of which must bring back white.
fn count_white(shape: impl Geometry + 'static, eye: Point3, middle: Point3, s: f64) -> usize {
    let alone = world(Color::WHITE, Color::BLACK).with(shape, mirror(Color::BLACK, Color::WHITE));
    let mut hits = 0;
    for n in 0..4000 {
        let random = PixelRandom::new(14, n, 0);
        let aim = [0, 1, 2].map(|i| (2.0 * random.uniform(i) - 1.0) * s);
        let ray = Ray::new(eye, middle + Vector3::from_glam(aim.into()) - eye).unwrap();
        assert_eq!(trace(&alone, &ray, 2), Color::WHITE, "{ray:?} at size {s}");
        hits += usize::from(trace(&alone, &ray, 1) == Color::BLACK);
    }
    hits
}
