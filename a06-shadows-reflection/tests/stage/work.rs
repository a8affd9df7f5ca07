//! The work that the lesson and all work take, counted by hand.

use std::process::Command;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, Ray, View};
use a04_intersections::{Plane, Sphere};
use a05_lighting::{Phong, PointLight, SingleColor};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface, traced};
use common::steps::{self, Counts, StepKind};
use common::{Color, Renderer, Settings, Size};

const RAYS: u32 = 50;

fn plane() -> Plane {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap()
}

/// Black surroundings, with a lamp at a height.
fn lit(height: f64, casts_shadows: bool) -> ShadowedWorld {
    lit_by(Color::WHITE, height, casts_shadows)
}

fn lit_by(color: Color, height: f64, casts_shadows: bool) -> ShadowedWorld {
    let light = PointLight::new(color, Point3::new(0.0, height, 0.0)).unwrap();
    ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))
        .unwrap()
        .lit_by(LightSource::new(light, casts_shadows))
}

fn black_highlight() -> Box<dyn Surface> {
    Box::new(Phong::new(Color::WHITE, Color::BLACK, 64.0).unwrap())
}

fn matt_without_shadows() -> ShadowedWorld {
    lit(5.0, false).with(plane(), black_highlight())
}

fn lamp_below() -> ShadowedWorld {
    lit(-5.0, true).with(plane(), black_highlight())
}

fn black_lamp() -> ShadowedWorld {
    lit_by(Color::BLACK, 5.0, true).with(plane(), black_highlight())
}

fn black_floor() -> ShadowedWorld {
    let black = Reflective::new(Color::BLACK, Color::BLACK, 1.0, Color::BLACK).unwrap();
    lit(5.0, true).with(plane(), Box::new(black))
}

fn single_color() -> ShadowedWorld {
    let red = SingleColor::new(Color::RED).unwrap();
    lit(5.0, true).with(plane(), Box::new(red))
}

/// The huge ball around the lamp is first in the list: it blocks the shadow ray, which
/// need not be tested against the floor.
fn occluder() -> ShadowedWorld {
    let ball = Sphere::new(Point3::new(0.0, 100.0, 0.0), 5.0).unwrap();
    let world = lit(100.0, true).with(ball, black_highlight());
    world.with(plane(), black_highlight())
}

fn mirror() -> ShadowedWorld {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, half).unwrap();
    lit(5.0, true).with(plane(), Box::new(mirror))
}

/// Looks down at the floor, each column at another place.
struct Downwards;

impl Camera for Downwards {
    fn ray_for(&self, _: Size, x: f64, _: f64) -> Ray {
        let o = Point3::new(x + 10.0, 1.0, 3.0);
        Ray::new(o, Vector3::new(0.5, -1.0, 0.25)).unwrap()
    }
}

/// The work for [`RAYS`] rays in the lesson, and all work. The colours are the
/// same, the work is not.
fn work(world: fn() -> ShadowedWorld, depth: u32) -> [Counts; 2] {
    let work = [Renderer::Lesson, Renderer::NoOmissions].map(|renderer| {
        let settings = Settings {
            size: Size::new(RAYS, 1).unwrap(),
            depth,
            renderer,
            ..Settings::default()
        };
        let view = traced(View::new(Downwards, world()));
        let (image, counts) = steps::counted(|| view.render(&settings, &())).unwrap();
        (image.unwrap(), counts)
    });
    assert!(work[0].0 == work[1].0);
    work.map(|(_, counts)| counts)
}

/// Each pair is the work of the lesson and all work, for a ray. All work tests the matt
/// floor three times: for the ray, the shadow ray and the reflected one, which goes up into
/// the dark.
#[test]
fn the_work_that_is_left_out_is_not_counted() {
    let cases: [(fn() -> ShadowedWorld, _, _, _, _, _); 7] = [
        (matt_without_shadows, 3, [1, 3], [0, 1], [0, 1], [0, 1]),
        (lamp_below, 1, [1, 2], [0, 1], [0, 0], [0, 1]),
        (black_lamp, 1, [1, 2], [0, 1], [0, 0], [0, 1]),
        (black_floor, 1, [1, 2], [0, 1], [0, 0], [0, 1]),
        (single_color, 1, [1, 2], [0, 1], [0, 0], [0, 0]),
        (occluder, 1, [3, 4], [1, 1], [0, 0], [0, 0]),
        (mirror, 2, [3, 3], [1, 1], [1, 1], [0, 1]),
    ];
    for (case, (world, depth, tests, shadow, reflected, powers)) in cases.into_iter().enumerate() {
        let counts = work(world, depth);
        for (work, expected) in [
            (StepKind::CameraRay, [1, 1]),
            (StepKind::Test, tests),
            (StepKind::ShadowRay, shadow),
            (StepKind::ReflectedRay, reflected),
            (StepKind::Power, powers),
        ] {
            let found = [0, 1].map(|i| counts[i][work] / u64::from(RAYS));
            assert_eq!(found, expected, "{work:?} of case {case}");
        }
    }
}

#[test]
fn the_program_explains_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_a06-shadows-reflection"))
        .args(["render", "aab", "--explain", "--size", "8x6"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let row = |work| text.lines().find(|row| row.trim_start().starts_with(work));
    let has = |work, part| row(work).is_some_and(|row| row.contains(part));
    let columns = "48             48";
    assert!(has("primary rays", columns), "{text}");
    let mirrors = "reflected rays from surfaces that mirror nothing:";
    assert!(has(mirrors, "48 reflected rays"), "{text}");
    assert!(has("largest difference", "0.0e0"), "{text}");
    let picture = "out/a06-shadows-reflection-aab.png";
    assert!(folder.path().join(picture).is_file());
}
