//! A mirror shows the mirrored scene. Two mirrors that face each other, and mirrors under
//! several lights, are the extreme cases M01 to M19; curved mirrors, depth and background
//! are the exercise `mirror`.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Plane, Sphere};
use a05_lighting::SingleColor;
use a06_shadows_reflection::{RecursiveTracer, Reflective, ShadowedWorld};
use common::Color;
use testing::assert_refused;

const WHITE: Color = Color::WHITE;

/// A plane mirror shows the view of an eye behind it, without the mirror.
#[test]
fn a_plane_mirror_shows_the_mirrored_scene() {
    let gray = Color::gray(0.5);
    let balls = || {
        let colors = [Color::RED, Color::GREEN, Color::BLUE, Color::YELLOW];
        let empty = ShadowedWorld::empty(gray, Color::BLACK).unwrap();
        (0..4).fold(empty, |world, n| {
            let x = f64::from(n) * 1.7 - 2.5;
            let ball = Sphere::new(Point3::new(x, 1.5 + 0.3 * x, 0.4 * x), 0.8).unwrap();
            let color = SingleColor::new(colors[n as usize]).unwrap();
            world.with(ball, Box::new(color))
        })
    };
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let mirror = Reflective::new(Color::BLACK, Color::BLACK, 64.0, WHITE).unwrap();
    let (without, with_mirror) = (balls(), balls().with(floor, Box::new(mirror)));
    let trace = |world, ray: &Ray, depth| RecursiveTracer::new(world).trace(ray, depth);
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

#[test]
fn bad_arguments_are_refused_by_name() {
    for number in [f64::NAN, f64::INFINITY, -0.5, 1.0_f64.next_up()] {
        let reflective = Reflective::new(WHITE, WHITE, 1.0, Color::new(1.0, number, 1.0));
        assert_refused(reflective, "reflection is", "from 0 to 1");
    }
    let bad = Color::new(1.0, f64::NAN, 1.0);
    for (diffuse, specular, exponent, name) in [
        (bad, WHITE, 1.0, "diffuse is"),
        (WHITE, bad, 1.0, "specular is"),
        (WHITE, WHITE, -0.5, "exponent is"),
    ] {
        assert_refused(
            Reflective::new(diffuse, specular, exponent, WHITE),
            name,
            "",
        );
    }
}
