//! The work that the lesson and all work take, counted by hand, and the plan that names
//! the difference.

use std::process::Command;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, Ray};
use a04_intersections::fast::shapes;
use a04_intersections::{Plane, Sphere};
use a05_lighting::{Phong, PointLight, SingleColor};
use a06_shadows_reflection::all_work::{self, NaiveTracer};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, counted, diagonal_camera,
    traced_scene,
};
use common::tally::{self, Tally, Work};
use common::{Color, Settings, Size};

const RAYS: u32 = 50;

fn plane() -> Plane {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap()
}

/// Black surroundings, with a lamp at a height.
fn lit(height: f64, casts_shadows: bool) -> ShadowedWorld {
    let light = PointLight::new(Color::WHITE, Point3::new(0.0, height, 0.0)).unwrap();
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
fn work(world: fn() -> ShadowedWorld, depth: u32) -> [Tally; 2] {
    let settings = Settings::default();
    let colors = |trace: &(dyn Fn(&Ray) -> Color + Sync)| {
        let camera = counted::camera(Box::new(Downwards), &settings);
        let trace = || {
            let rays = (0..RAYS).map(|x| camera.ray_for(settings.size, x.into(), 0.0));
            rays.map(|ray| trace(&ray)).collect::<Vec<_>>()
        };
        tally::counted(trace).unwrap()
    };
    let lesson = counted::world(world()).unwrap();
    let all = counted::world(all_work::world(world()).unwrap()).unwrap();
    let (expected, needed) = colors(&|ray| RecursiveTracer::new(&lesson).trace(ray, depth));
    let (got, all) = colors(&|ray| NaiveTracer::new(&all).trace(ray, depth));
    assert_eq!(expected, got);
    [needed, all]
}

fn plan(world: fn() -> ShadowedWorld) -> String {
    let view = move |_: &Settings| Ok((diagonal_camera(3.0)?, world()));
    let scene = traced_scene("floor", "a floor", view, shapes);
    scene.plan(&Settings::default()).unwrap().to_string()
}

/// Each pair is the work of the lesson and all work, for a ray. All work tests the matt
/// floor three times: for the ray, the shadow ray and the reflected one, which goes up into
/// the dark.
#[test]
fn the_plan_names_the_work_that_is_left_out() {
    let cases: [(fn() -> ShadowedWorld, _, _, _, _, _); 5] = [
        (matt_without_shadows, 3, [1, 3], [0, 1], [0, 1], [0, 1]),
        (lamp_below, 1, [1, 2], [0, 1], [0, 0], [0, 1]),
        (single_color, 1, [1, 2], [0, 1], [0, 0], [0, 0]),
        (occluder, 1, [3, 4], [1, 1], [0, 0], [0, 0]),
        (mirror, 2, [3, 3], [1, 1], [1, 1], [0, 1]),
    ];
    for (case, (world, depth, tests, shadow, reflected, powers)) in cases.into_iter().enumerate() {
        let (tallies, plan) = (work(world, depth), plan(world));
        assert_eq!(tallies[0][Work::PrimaryRay], RAYS.into());
        for (work, expected, words) in [
            (Work::IntersectionTest, tests, "objects"),
            (Work::ShadowRay, shadow, "light"),
            (Work::ReflectedRay, reflected, "reflected rays"),
            (Work::Power, powers, "powers"),
        ] {
            let found = [0, 1].map(|i| tallies[i][work] / u64::from(RAYS));
            assert_eq!(found, expected, "{work:?} of case {case}");
            let is_named = plan.contains(words);
            assert!(is_named || found[0] == found[1], "{work:?}: {plan}");
        }
    }
    // The work that the mirror needs is no omission.
    assert!(!plan(mirror).contains("reflected rays"));
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
    for part in [
        "primary rays: 48",
        "2 of 2 objects: they do not mirror",
        "same bits",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let picture = "out/a06-shadows-reflection-aab.png";
    assert!(folder.path().join(picture).is_file());
}
