//! Which work the lesson and all work take, counted by hand.

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
use common::{Color, Settings, Size};
use measure::tally::{self, Tally, Work};

const RAYS: u32 = 50;

fn floor() -> Plane {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap()
}

/// Black on all sides, with one lamp at a height.
fn world(height: f64, casts_shadows: bool) -> ShadowedWorld {
    let light = PointLight::new(Color::WHITE, Point3::new(0.0, height, 0.0)).unwrap();
    ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))
        .unwrap()
        .lit_by(LightSource::new(light, casts_shadows))
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
fn work(world: &(dyn Fn() -> ShadowedWorld + Sync), depth: u32) -> [Tally; 2] {
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

/// How often work was done for each ray, in the lesson and in all.
fn per_ray(tallies: [Tally; 2], work: Work) -> [u64; 2] {
    tallies.map(|tally| {
        assert_eq!(tally[Work::PrimaryRay], RAYS.into());
        assert_eq!(tally[work] % u64::from(RAYS), 0);
        tally[work] / u64::from(RAYS)
    })
}

fn black_highlight() -> Box<dyn Surface> {
    Box::new(Phong::new(Color::WHITE, Color::BLACK, 64.0).unwrap())
}

/// All work tests the floor three times: for the ray, the shadow ray and the
/// reflected one, which goes up into the dark.
#[test]
fn a_matt_floor_without_shadows_takes_a_ray_and_no_power() {
    let tallies = work(&|| world(5.0, false).with(floor(), black_highlight()), 3);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [1, 3]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::Power), [0, 1]);
}

#[test]
fn a_lamp_below_the_floor_takes_no_shadow_ray() {
    let tallies = work(&|| world(-5.0, true).with(floor(), black_highlight()), 1);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [0, 0]);
}

#[test]
fn a_single_color_takes_no_shadow_ray() {
    let material = Box::new(SingleColor::new(Color::RED).unwrap());
    let tallies = work(&|| world(5.0, true).with(floor(), material.clone()), 1);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [1, 2]);
}

/// The huge ball around the lamp is first in the list. The ray is tested against
/// it and the floor. It keeps the light away, so that the shadow ray need not be
/// tested against the floor.
#[test]
fn the_first_occluder_suffices() {
    let ball = Sphere::new(Point3::new(0.0, 100.0, 0.0), 5.0).unwrap();
    let world = || {
        let world = world(100.0, true).with(ball, black_highlight());
        world.with(floor(), black_highlight())
    };
    let tallies = work(&world, 1);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [3, 4]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [1, 1]);
}

#[test]
fn needed_work_is_done() {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, half).unwrap();
    let tallies = work(&|| world(5.0, true).with(floor(), Box::new(mirror)), 2);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [1, 1]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [1, 1]);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [3, 3]);
}

/// Each kind of omission is in the plan of a world that has the reason for it,
/// and in no other.
#[test]
fn the_plan_names_the_work_that_is_left_out() {
    fn plan(casts_shadows: bool, surface: fn() -> Box<dyn Surface>) -> String {
        let view = move |_: &Settings| {
            let world = world(5.0, casts_shadows).with(floor(), surface());
            Ok((diagonal_camera(3.0)?, world))
        };
        let scene = traced_scene("floor", "a floor", view, shapes);
        scene.plan(&Settings::default()).unwrap().to_string()
    }
    let (behind, first) = ("shadow rays to lights behind", "behind the first object");
    let matt = plan(false, black_highlight);
    for present in [
        "objects: 1",
        "lights: 1",
        "random numbers",
        "powers where",
        "shadow rays to 1 of 1 lights",
        "reflected rays from 1 of 1",
    ] {
        assert!(matt.contains(present), "{present}: {matt}");
    }
    for absent in [behind, first] {
        assert!(!matt.contains(absent), "{absent}: {matt}");
    }
    let mirror = plan(true, || {
        let white = Color::WHITE;
        Box::new(Reflective::new(white, white, 1.0, white).unwrap())
    });
    for present in [behind, first] {
        assert!(mirror.contains(present), "{present}: {mirror}");
    }
    for absent in ["reflected rays", "shadow rays to 1", "light on"] {
        assert!(!mirror.contains(absent), "{absent}: {mirror}");
    }
}

#[test]
fn the_program_explains_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_a06-shadows-reflection"))
        .args(["render", "aab", "--explain", "--size", "8x6"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(output.status.success());
    let said = String::from_utf8(output.stdout).unwrap();
    for part in [
        "primary rays: 48",
        "reflected rays from 2 of 2 objects: they do not mirror (same bits)",
        "largest difference of a channel 0.0e0",
        "; everything",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let picture = folder.path().join("out/a06-shadows-reflection-aab.png");
    assert!(picture.is_file());
}
