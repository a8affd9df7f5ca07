//! Mirrors: geometric series, depth, and what is seen in them.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SingleColor};
use a06_shadows_reflection::all_work::{self, NaiveTracer};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use approx::assert_relative_eq;
use common::{ArgumentError, Color};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const X: Vector3 = Vector3::new(1.0, 0.0, 0.0);

/// Matt white, black, or what else is asked for, and as reflecting.
fn mirror(diffuse: Color, reflection: Color) -> Box<dyn Surface> {
    Box::new(Reflective::new(diffuse, Color::BLACK, 64.0, reflection).unwrap())
}

fn world(background: Color, ambient: Color) -> ShadowedWorld {
    ShadowedWorld::empty(background, ambient).unwrap()
}

fn plane(through: Point3, n: Vector3) -> Plane {
    Plane::new(through, n.as_normal()).unwrap()
}

fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}

/// Two mirrors that face each other at this distance, each of the colour 1.
fn corridor(k: f64, gap: f64) -> ShadowedWorld {
    let wall = || mirror(Color::WHITE, Color::gray(k));
    world(Color::BLACK, Color::WHITE)
        .with(plane(Point3::ORIGIN, X), wall())
        .with(plane(Point3::ORIGIN + X * gap, X), wall())
}

/// From half way between the mirrors.
fn along(d: Vector3, gap: f64) -> Ray {
    Ray::new(Point3::ORIGIN + X * (gap / 2.0), d).unwrap()
}

/// 1 + k + k² + .. of `depth` terms is (1 - k^depth) / (1 - k), and `depth` if
/// k is 1. Bound: one rounding each in the power and in the sum, depth eps. A
/// gap below any fixed length that a reflected ray might skip is none the less
/// a gap.
#[test]
fn two_mirrors_show_each_other_in_a_geometric_series() {
    for k in [0.0, 0.5, 0.9, 0.99, 1.0] {
        for depth in [1, 2, 5, 10, 50, 1000] {
            let power: f64 = (0..depth).map(|_| k).product();
            let expected = if k < 1.0 {
                (1.0 - power) / (1.0 - k)
            } else {
                f64::from(depth)
            };
            let bound = f64::from(depth) * 2.0 * f64::EPSILON;
            for gap in [5e-4, 1.0, 1e6] {
                for d in [X, -X, Vector3::new(3.0, -1.0, 2.0)] {
                    let color = trace(&corridor(k, gap), &along(d, gap), depth);
                    assert_relative_eq!(color.r, expected, max_relative = bound);
                    assert_eq!((color.g, color.b), (color.r, color.r));
                }
            }
        }
    }
}

/// A function that calls itself a million times ends the program.
#[test]
fn a_depth_of_a_million_needs_no_stack() {
    let color = trace(&corridor(1.0, 1.0), &along(X, 1.0), 1_000_000);
    assert_eq!(color, Color::gray(1e6));
    // Powers of 1/2 become 0 on the way, and the sum 2.
    let color = trace(&corridor(0.5, 1.0), &along(X, 1.0), 1_000_000);
    assert_eq!(color, Color::gray(2.0));
}

#[test]
fn depth_counts_the_surfaces_that_a_ray_may_meet() {
    let world = world(Color::BLUE, Color::WHITE).with(
        plane(Point3::ORIGIN, UP),
        mirror(Color::gray(0.5), Color::gray(0.5)),
    );
    let down = Ray::new(Point3::new(0.0, 3.0, 0.0), -UP).unwrap();
    assert_eq!(trace(&world, &down, 0), Color::BLACK);
    assert_eq!(trace(&world, &down, 1), Color::gray(0.5));
    let with_sky = Color::gray(0.5) + Color::BLUE * 0.5;
    assert_eq!(trace(&world, &down, 2), with_sky);
    assert_eq!(trace(&world, &down, u32::MAX), with_sky);
    let up = Ray::new(Point3::new(0.0, 3.0, 0.0), UP).unwrap();
    assert_eq!(trace(&world, &up, 0), Color::BLACK);
    assert_eq!(trace(&world, &up, 1), Color::BLUE);
}

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

fn balls(world: ShadowedWorld) -> ShadowedWorld {
    let colors = [Color::RED, Color::GREEN, Color::BLUE, Color::YELLOW];
    colors
        .into_iter()
        .enumerate()
        .fold(world, |world, (n, color)| {
            let x = n as f64 * 1.7 - 2.5;
            let ball = Sphere::new(Point3::new(x, 1.5 + 0.3 * x, 0.4 * x), 0.8).unwrap();
            world.with(ball, Box::new(SingleColor::new(color).unwrap()))
        })
}

/// A plane mirror shows what an eye behind it would see without it.
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

/// The normal leans by 30 degrees, so that what comes straight from above is
/// sent away at 60 degrees, where a small ball hangs. By the face it would go
/// back up.
#[test]
fn a_mirror_of_curved_triangles_reflects_on_its_interpolated_normal() {
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

/// Mirrors, shadows and both kinds of lights.
fn everything() -> ShadowedWorld {
    let shiny = Phong::new(Color::gray(0.5), Color::WHITE, 20.0).unwrap();
    let tinted = Reflective::new(Color::RED, Color::WHITE, 64.0, Color::new(0.0, 0.5, 0.9));
    let (lbf, run) = (Point3::new(-4.0, 0.0, -3.0), Point3::new(-3.0, 2.0, 3.0));
    let sun = DirectionalLight::new(Color::gray(0.5), Vector3::new(1.0, -2.0, 0.5)).unwrap();
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 6.0, 4.0)).unwrap();
    balls(world(Color::new(0.1, 0.2, 0.3), Color::gray(0.25)))
        .with(
            plane(Point3::ORIGIN, UP),
            mirror(Color::gray(0.3), Color::gray(0.5)),
        )
        .with(AxisAlignedBox::new(lbf, run).unwrap(), Box::new(shiny))
        .with(
            Sphere::new(Point3::new(0.0, 4.0, -3.0), 2.0).unwrap(),
            Box::new(tinted.unwrap()),
        )
        .lit_by(LightSource::new(sun, true))
        .lit_by(LightSource::new(lamp, true))
}

fn views() -> Vec<Ray> {
    let view = |n| {
        let random = PixelRandom::new(15, n, 0);
        let d = [0, 1, 2].map(|i| random.uniform(i) * 2.0 - 1.0);
        let eye = Point3::new(1.0, 3.0, 8.0);
        let aim = Vector3::from_glam(d.into()) * 5.0 - Vector3::new(1.0, 1.0, 9.0);
        Ray::new(eye, aim).unwrap()
    };
    (0..2000).map(view).collect()
}

#[test]
fn with_all_work_the_colors_are_the_same() {
    let (lesson, all) = (everything(), all_work::world(everything()).unwrap());
    for ray in views() {
        for depth in [1, 2, 7] {
            let expected = trace(&lesson, &ray, depth);
            assert_eq!(NaiveTracer::new(&all).trace(&ray, depth), expected);
        }
    }
}

/// A counter of depth in the tracer, used up by the first ray, would darken
/// all others.
#[test]
fn a_tracer_remembers_nothing() {
    let world = everything();
    let tracer = RecursiveTracer::new(&world);
    let views = views();
    let forwards: Vec<_> = views.iter().map(|ray| tracer.trace(ray, 4)).collect();
    let backwards: Vec<_> = views.iter().rev().map(|ray| tracer.trace(ray, 4)).collect();
    assert!(forwards.iter().eq(backwards.iter().rev()));
    let fresh = views.iter().map(|ray| trace(&world, ray, 4));
    assert!(fresh.eq(forwards));
}

#[test]
fn a_mirror_of_nothing_is_the_shiny_surface_under_it() {
    let (diffuse, specular) = (Color::new(0.2, 0.4, 0.6), Color::gray(0.5));
    let ball = Sphere::new(Point3::new(0.0, 2.0, 0.0), 2.0).unwrap();
    let with = |surface: Box<dyn Surface>| {
        let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 6.0, 4.0)).unwrap();
        world(Color::WHITE, Color::gray(0.25))
            .with(ball, surface)
            .lit_by(LightSource::new(lamp, true))
    };
    let blind = Reflective::new(diffuse, specular, 8.0, Color::BLACK).unwrap();
    let [blind, shiny] = [
        with(Box::new(blind)),
        with(Box::new(Phong::new(diffuse, specular, 8.0).unwrap())),
    ];
    for ray in views() {
        assert_eq!(trace(&blind, &ray, 3), trace(&shiny, &ray, 3));
    }
}

#[test]
fn only_reflective_surfaces_reflect() {
    let white = Color::WHITE;
    let surfaces: [(Box<dyn Surface>, Color); 4] = [
        (Box::new(SingleColor::new(white).unwrap()), Color::BLACK),
        (Box::new(Lambert::new(white).unwrap()), Color::BLACK),
        (
            Box::new(Phong::new(white, white, 1.0).unwrap()),
            Color::BLACK,
        ),
        (mirror(white, Color::YELLOW), Color::YELLOW),
    ];
    for (surface, expected) in surfaces {
        assert_eq!(surface.reflection(), expected);
    }
}

#[test]
fn bad_arguments_are_refused_by_name() {
    let white = Color::WHITE;
    let assert_refused = |result: Result<Reflective, ArgumentError>, name: &str, allowed: &str| {
        let said = result.unwrap_err().to_string();
        assert!(said.starts_with(name) && said.contains(allowed), "{said}");
    };
    for number in [f64::NAN, f64::INFINITY, -0.5] {
        let bad = Color::new(1.0, 1.0, number);
        let (color, least) = ("channels from 0 to 1e50", "at least 0");
        for (result, name, allowed) in [
            (Reflective::new(bad, white, 1.0, white), "diffuse is", color),
            (
                Reflective::new(white, bad, 1.0, white),
                "specular is",
                color,
            ),
            (
                Reflective::new(white, white, number, white),
                "exponent is",
                least,
            ),
        ] {
            assert_refused(result, name, allowed);
        }
    }
    for number in [f64::NAN, f64::INFINITY, -0.5, 1.0_f64.next_up()] {
        let bad = Color::new(1.0, 1.0, number);
        let result = Reflective::new(white, white, 1.0, bad);
        assert_refused(result, "reflection is", "from 0 to 1");
    }
}
