//! What is left out: counts by hand of the work with and without omissions.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Focus, PinholeCamera, Ray, Sampler};
use a04_intersections::{Plane, Sphere};
use a05_lighting::{DirectionalLight, Lambert, Light, Material, Phong, PointLight, SingleColor};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, foci, traced_scene,
};
use common::{Bound, Color, Settings};
use measure::tally::{Tally, Work, counted};

const RAYS: u64 = 50;

fn floor() -> Plane {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap()
}

/// Black round about, with one lamp at a height.
fn world(height: f64, casts_shadows: bool) -> ShadowedWorld {
    let light = PointLight::new(Color::WHITE, Point3::new(0.0, height, 0.0)).unwrap();
    ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))
        .unwrap()
        .lit_by(LightSource::new(light, casts_shadows))
}

/// Looks down at the floor in [`RAYS`] places, with and without omissions: the
/// colours are the same, the work is not.
fn work(world: &ShadowedWorld, depth: u32) -> [Tally; 2] {
    let look = |omit| {
        let tracer = RecursiveTracer::new(world, omit);
        let colors = || {
            let rays = (0..RAYS).map(|i| {
                let o = Point3::new(i as f64 + 10.0, 1.0, 3.0);
                Ray::new(o, Vector3::new(0.5, -1.0, 0.25)).unwrap()
            });
            rays.map(|ray| tracer.trace(&ray, depth))
                .collect::<Vec<_>>()
        };
        counted(colors).unwrap()
    };
    let [(with, needed), (without, all)] = [true, false].map(look);
    assert_eq!(with, without);
    [needed, all]
}

/// The times per ray that work was done, needed and in all.
fn per_ray(tallies: [Tally; 2], work: Work) -> [u64; 2] {
    tallies.map(|tally| {
        assert_eq!(tally[work] % RAYS, 0);
        tally[work] / RAYS
    })
}

fn black_highlight() -> Box<dyn Surface> {
    Box::new(Phong::new(Color::WHITE, Color::BLACK, 64.0).unwrap())
}

/// Everything asks the floor three times: the ray, the shadow ray and the
/// reflected one, which goes up into the dark.
#[test]
fn a_matt_floor_under_a_lamp_without_shadows_takes_a_ray_and_no_power() {
    let tallies = work(&world(5.0, false).with(floor(), black_highlight()), 3);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [1, 3]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::Power), [0, 1]);
}

#[test]
fn a_lamp_below_the_floor_takes_no_shadow_ray() {
    let tallies = work(&world(-5.0, true).with(floor(), black_highlight()), 1);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [0, 0]);
}

#[test]
fn what_answers_no_light_takes_no_shadow_ray() {
    let dull: [Box<dyn Surface>; 3] = [
        Box::new(SingleColor::new(Color::RED).unwrap()),
        Box::new(Lambert::new(Color::BLACK).unwrap()),
        Box::new(Phong::new(Color::BLACK, Color::BLACK, 1.0).unwrap()),
    ];
    for material in dull {
        let tallies = work(&world(5.0, true).with(floor(), material), 1);
        assert_eq!(per_ray(tallies, Work::ShadowRay), [0, 1]);
        assert_eq!(per_ray(tallies, Work::IntersectionTest), [1, 2]);
    }
}

/// The huge ball around the lamp is first in the list. It is asked by the ray,
/// as is the floor, and keeps the light away, so that the floor need not be
/// asked by the shadow ray.
#[test]
fn the_first_thing_in_the_way_of_the_light_suffices() {
    let ball = Sphere::new(Point3::new(0.0, 100.0, 0.0), 5.0).unwrap();
    let world = world(100.0, true)
        .with(ball, black_highlight())
        .with(floor(), black_highlight());
    let tallies = work(&world, 1);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [3, 4]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [1, 1]);
}

#[test]
fn what_is_needed_is_done() {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, half).unwrap();
    let tallies = work(&world(5.0, true).with(floor(), Box::new(mirror)), 2);
    assert_eq!(per_ray(tallies, Work::ReflectedRay), [1, 1]);
    assert_eq!(per_ray(tallies, Work::ShadowRay), [1, 1]);
    assert_eq!(per_ray(tallies, Work::IntersectionTest), [3, 3]);
}

/// Each kind of omission is in the plan of a world that has the reason for it,
/// and in no other.
#[test]
fn the_plan_tells_what_is_left_out() {
    let plan = |world: &ShadowedWorld| {
        let plan = RecursiveTracer::new(world, true).plan(Sampler::plan(&Settings::default()));
        plan.to_string()
    };
    let matt = plan(&world(5.0, false).with(floor(), black_highlight()));
    assert!(matt.contains("shadow rays to 1 of 1 lights"), "{matt}");
    assert!(matt.contains("reflected rays from 1 of 1"), "{matt}");
    assert!(matt.contains("powers on 1 of 1 objects"), "{matt}");
    assert!(matt.contains("random numbers"), "{matt}");
    for absent in ["faces away from a light", "the first object in the way"] {
        assert!(!matt.contains(absent), "{absent}: {matt}");
    }

    let white = Color::WHITE;
    let mirror = Reflective::new(white, white, 1.0, white).unwrap();
    let bright = plan(&world(5.0, true).with(floor(), Box::new(mirror)));
    for present in ["faces away from a light", "the first object in the way"] {
        assert!(bright.contains(present), "{present}: {bright}");
    }
    for absent in [
        "reflected rays",
        "shadow rays to",
        "powers on 1",
        "light on",
    ] {
        assert!(!bright.contains(absent), "{absent}: {bright}");
    }
}

fn half_mirror() -> Box<dyn Surface> {
    let half = Color::gray(0.5);
    Box::new(Reflective::new(Color::WHITE, Color::BLACK, 1.0, half).unwrap())
}

/// Of the error that a picture may have an eighth is for mirrors, if there are
/// any.
#[test]
fn the_plan_bounds_what_mirrors_leave_out() {
    type Make = fn() -> Box<dyn Surface>;
    let bounds = |surface: Make, max_error| -> Vec<Bound> {
        let made = move |_: &Settings| Ok(world(5.0, true).with(floor(), surface()));
        let scene = traced_scene("mirror", "a mirror", 3.0, made);
        let settings = Settings {
            max_error,
            ..Settings::default()
        };
        let omissions = scene.plan(&settings).unwrap().omissions;
        let bounds = omissions.into_iter().map(|omission| omission.bound);
        bounds.filter(|bound| *bound != Bound::SameBits).collect()
    };
    let error = Bound::Error(0.5);
    let half_mirror_cut = Bound::Channel(0.0625);
    assert_eq!(bounds(half_mirror, Some(0.5)), [error, half_mirror_cut]);
    assert_eq!(bounds(half_mirror, None), []);
    assert_eq!(bounds(black_highlight, Some(0.5)), [error]);
}

/// No ray goes to a light without shadows.
#[test]
fn the_foci_are_those_of_the_camera_and_of_lights_with_shadows() {
    let (eye, lamp) = (Point3::new(1.0, 2.0, 3.0), Point3::new(0.0, 5.0, 0.0));
    let camera = PinholeCamera::new(eye, 1.0).unwrap();
    let down = Vector3::new(0.0, -1.0, 0.0);
    let sun = |casts_shadows| {
        LightSource::new(
            DirectionalLight::new(Color::RED, down).unwrap(),
            casts_shadows,
        )
    };
    let [point, direction] = [Focus::Point(lamp), Focus::Direction(down)];
    let eye = Focus::Point(eye);
    for (lamp, sun_casts, expected) in [
        (true, true, vec![eye, point, direction]),
        (false, true, vec![eye, direction]),
        (true, false, vec![eye, point]),
        (false, false, vec![eye]),
    ] {
        let world = world(5.0, lamp).lit_by(sun(sun_casts));
        assert_eq!(foci(&camera, &world), expected);
    }
    assert_eq!(sun(true).brightest(), Color::RED);
}

/// As little as the shiny surface under it.
#[test]
fn mirrors_answer_light_and_have_highlights_like_their_surface() {
    let (white, black) = (Color::WHITE, Color::BLACK);
    for (diffuse, specular) in [
        (white, white),
        (white, black),
        (black, white),
        (black, black),
    ] {
        let shiny = Phong::new(diffuse, specular, 1.0).unwrap();
        let mirror = Reflective::new(diffuse, specular, 1.0, white).unwrap();
        assert_eq!(mirror.answers_light(), shiny.answers_light());
        assert_eq!(mirror.has_highlight(), shiny.has_highlight());
        let light = Color::new(0.5, 1.0, 2.0);
        assert_eq!(
            mirror.brightest(light, light),
            shiny.brightest(light, light)
        );
    }
}

/// Mirrors of the colour 1 and the share 1/2 bring back no more than 2, of which
/// after three of them a quarter is left.
#[test]
fn what_is_as_bright_as_the_bound_is_followed() {
    let up = Vector3::new(0.0, 1.0, 0.0);
    let ceiling = Plane::new(Point3::ORIGIN + up * 2.0, up.as_normal()).unwrap();
    let world = ShadowedWorld::empty(Color::BLACK, Color::WHITE).unwrap();
    let world = world
        .with(floor(), half_mirror())
        .with(ceiling, half_mirror());
    let ray = Ray::new(Point3::new(0.0, 1.0, 0.0), up).unwrap();
    for (bound, surfaces) in [(0.25, 4), (0.25_f64.next_up(), 3)] {
        let tracer = RecursiveTracer::new(&world, true).cut_below(Some(bound));
        let (_, tally) = counted(|| tracer.trace(&ray, 100)).unwrap();
        assert_eq!(tally[Work::ReflectedRay] + 1, surfaces);
    }
}

/// Two mirrors of colour 1 that show each other bring back 1 / (1 - k). After D
/// surfaces k^D / (1 - k) of it is missing, which is below half a grey level,
/// 1/510, from D = 10, 36 and 82 on.
#[test]
fn mirrors_are_followed_as_far_as_they_can_be_seen() {
    let half_grey_level = 1.0 / 510.0;
    for (k, surfaces) in [(0.5, 10), (0.8, 36), (0.9, 82)] {
        let (plane, x) = (floor(), Vector3::new(0.0, 1.0, 0.0));
        let ceiling = Plane::new(Point3::ORIGIN + x * 2.0, x.as_normal()).unwrap();
        let white = || {
            let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, Color::gray(k));
            Box::new(mirror.unwrap())
        };
        let world = ShadowedWorld::empty(Color::BLACK, Color::WHITE).unwrap();
        let world = world.with(plane, white()).with(ceiling, white());
        let ray = Ray::new(Point3::new(0.0, 1.0, 0.0), x).unwrap();
        let trace = |omit| {
            let tracer = RecursiveTracer::new(&world, omit).cut_below(Some(half_grey_level));
            let (color, tally) = counted(|| tracer.trace(&ray, 1000)).unwrap();
            (color.r, tally[Work::ReflectedRay] + 1)
        };
        let (seen, met) = trace(true);
        assert_eq!(met, surfaces, "{k}");
        let missing = 1.0 / (1.0 - k) - seen;
        let expected = (0..surfaces).map(|_| k).product::<f64>() / (1.0 - k);
        assert!(missing > 0.0 && missing < half_grey_level);
        // Bound: a rounding for each surface, of a sum below 10.
        assert!((missing - expected).abs() < 10.0 * 82.0 * f64::EPSILON);
        assert_eq!(trace(false).1, 1000);
    }
}

/// What mirrors all light, or tells no bound of its own, is followed to the end.
#[test]
fn what_may_be_seen_is_followed() {
    let white = Reflective::new(Color::WHITE, Color::WHITE, 1.0, Color::WHITE).unwrap();
    let world = world(5.0, true).with(floor(), Box::new(white));
    let ray = Ray::new(Point3::new(0.0, 1.0, 0.0), Vector3::new(1.0, -1.0, 0.0)).unwrap();
    let trace = |bound| {
        let tracer = RecursiveTracer::new(&world, true).cut_below(bound);
        counted(|| tracer.trace(&ray, 9)).unwrap()
    };
    assert_eq!(trace(Some(1e9)), trace(None));
}

/// The program tells plan, counts and difference, and writes the picture.
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
        "everything takes",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let picture = folder.path().join("out/a06-shadows-reflection-aab.png");
    assert!(picture.is_file());
}
