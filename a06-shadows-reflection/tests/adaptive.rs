//! Adaptive sampling of traced worlds: it looks closer where the world says that
//! something narrow may hide.

use std::sync::Mutex;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, Focus, Radiance, Ray, render_together};
use a04_intersections::{Plane, Sphere};
use a05_lighting::{DirectionalLight, Lambert, Phong};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, TracedLight,
};
use common::{Color, Image, Sampled, Sampling, Settings, Size};
use measure::experiment::HALF_GREY_LEVEL;

/// A pixel is 1 wide where z is 0, and coordinates there are places in the picture. The
/// eye is far above its middle, so that spheres appear as discs.
struct FromAbove;

const EYE: Point3 = Point3::new(39.5, 29.5, 1000.0);

impl Camera for FromAbove {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        Ray::new(EYE, Point3::new(x, y, 0.0) - EYE).unwrap()
    }
}

fn sphere(middle: [f64; 3], r: f64) -> Sphere {
    let [x, y, z] = middle;
    Sphere::new(Point3::new(x, y, z), r).unwrap()
}

fn matt(gray: f64) -> Box<dyn Surface> {
    Box::new(Lambert::new(Color::gray(gray)).unwrap())
}

/// A black floor below all spheres, in light that falls as the eye looks.
fn floor() -> ShadowedWorld {
    let sun = DirectionalLight::new(Color::gray(0.5), Vector3::new(0.0, 0.0, -1.0)).unwrap();
    let up = Normal3::new(0.0, 0.0, 1.0);
    let plane = Plane::new(Point3::new(0.0, 0.0, -5000.0), up).unwrap();
    ShadowedWorld::empty(Color::BLACK, Color::gray(0.5))
        .unwrap()
        .lit_by(LightSource::new(sun, true))
        .with(plane, matt(0.0))
}

/// A disc 1.6 pixels wide around a corner of pixels that is none of a block: the
/// columns and rows from 40 to 41 are the second ones of two.
fn with_small_sphere() -> ShadowedWorld {
    floor().with(sphere([40.5, 30.5, 0.0], 0.8), matt(1.0))
}

/// It is all that the picture shows: at its corners, 50 from the middle, its normal is
/// less than 3 degrees from the light, whose share changes by a thousandth.
fn with_large_sphere() -> ShadowedWorld {
    floor().with(sphere([39.5, 29.5, -1000.0], 1000.0), matt(1.0))
}

fn settings() -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(HALF_GREY_LEVEL),
        ..Settings::default()
    }
}

fn traced(world: &ShadowedWorld, omit: bool) -> TracedLight<'_> {
    TracedLight {
        tracer: RecursiveTracer::new(world, omit),
        depth: 1,
    }
}

fn prepared(world: ShadowedWorld) -> ShadowedWorld {
    world.prepared([Focus::Point(EYE)])
}

fn adaptive(light: impl Radiance) -> (Image, Sampled) {
    let told = Mutex::new(Sampled::default());
    let image = render_together(&FromAbove, light, &settings(), &told).unwrap();
    (image, told.into_inner().unwrap())
}

fn stratified(world: &ShadowedWorld) -> Image {
    let settings = Settings {
        samples: 32 * 32,
        sampling: Sampling::Stratified,
        max_error: None,
        seed: 0x5EED,
        ..settings()
    };
    render_together(&FromAbove, traced(world, true), &settings, &()).unwrap()
}

fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let channels = |image: &Image| -> Vec<f64> {
        let pixels = image.pixels().iter();
        pixels.flat_map(|color| color.channels()).collect()
    };
    let (a, b) = (channels(a), channels(b));
    let squares = a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// The same light, of which nobody says that something may hide.
struct Hushed<'a>(TracedLight<'a>);

impl Radiance for Hushed<'_> {
    fn along(&self, rays: &[Ray], light: &mut [Color]) {
        self.0.along(rays, light);
    }

    fn may_hide(&self, _: &[Ray; 4], _: f64) -> bool {
        false
    }
}

#[test]
fn a_small_sphere_alone_is_found() {
    let world = prepared(with_small_sphere());
    let reference = stratified(&world);
    let error = |(image, _)| root_mean_square(&image, &reference);
    // Of one small disc there are too few cells for their errors to cancel out.
    let found = error(adaptive(traced(&world, true)));
    assert!(found < 1.5 * HALF_GREY_LEVEL, "{found}");
    let missed = error(adaptive(Hushed(traced(&world, true))));
    assert!(missed > 5.0 * HALF_GREY_LEVEL, "{missed}");
}

/// It hides in one tile of 16 x 16 pixels, which has 17 x 17 corners; of those, 5 x 5
/// are corners of blocks. All others of the picture have the 21 x 16 of its blocks.
#[test]
fn only_where_it_hides_are_there_more_samples() {
    let world = prepared(with_small_sphere());
    let (_, sampled) = adaptive(traced(&world, true));
    let least = 21 * 16 + 17 * 17 - 5 * 5;
    // And those of the edge: no more than a whole tile of a sample a pixel.
    assert!((least..least + 256).contains(&sampled.samples), "{sampled}");
}

/// The corners of 20 x 15 blocks are 21 x 16.
#[test]
fn large_smooth_things_take_a_sixteenth_of_a_sample_a_pixel() {
    for world in [floor(), with_large_sphere()].map(prepared) {
        let (image, sampled) = adaptive(traced(&world, true));
        assert_eq!((sampled.samples, sampled.most), (21 * 16, 1));
        let error = root_mean_square(&image, &stratified(&world));
        assert!(error < 1e-4, "{error}");
    }
}

/// The corners of 80 x 60 pixels are 81 x 61.
#[test]
fn where_nothing_is_known_they_take_a_whole_one() {
    for world in [floor(), with_large_sphere()] {
        let (_, unprepared) = adaptive(traced(&world, true));
        assert!(unprepared.samples >= 81 * 61, "{unprepared}");
        let (_, with_all_work) = adaptive(traced(&prepared(world), false));
        assert!(with_all_work.samples >= 81 * 61, "{with_all_work}");
    }
}

/// Rays from the eye to the corners of the tile in the middle of the picture.
fn tile() -> [Ray; 4] {
    [(32.0, 40.0), (48.0, 40.0), (32.0, 24.0), (48.0, 24.0)]
        .map(|(x, y)| FromAbove.ray_for(settings().size, x, y))
}

/// Even among planes, of which a world that is asked says that they hide nothing.
#[test]
fn an_unprepared_world_and_a_tracer_that_omits_nothing_may_hide_everything() {
    for world in [floor, with_large_sphere] {
        let may_hide = |world: &_, omit| traced(world, omit).may_hide(&tile(), 0.1);
        assert_eq!(
            [true, false].map(|omit| may_hide(&world(), omit)),
            [true; 2]
        );
        let world = prepared(world());
        assert_eq!(
            [true, false].map(|omit| may_hide(&world, omit)),
            [false, true]
        );
    }
}

/// The sphere is a tenth of the tile wide.
#[test]
fn what_the_world_says_of_a_share_is_what_the_light_says() {
    let world = prepared(with_small_sphere());
    let light = traced(&world, true);
    assert_eq!(
        [0.101, 0.099].map(|share| light.may_hide(&tile(), share)),
        [true, false]
    );
}

/// Of two spheres the upper one mirrors: its flanks show the lower one.
#[test]
fn light_along_rays_is_that_of_the_tracer_to_the_last_bit() {
    let shine: Box<dyn Surface> =
        Box::new(Phong::new(Color::new(0.9, 0.5, 0.1), Color::gray(0.3), 20.0).unwrap());
    let half = Color::gray(0.5);
    let mirror: Box<dyn Surface> = Box::new(Reflective::new(half, half, 9.0, half).unwrap());
    let world = floor()
        .with(sphere([39.5, 29.5, -1000.0], 990.0), shine)
        .with(sphere([50.0, 30.0, 3.0], 12.0), mirror);
    let rays: Vec<_> = (0..79)
        .map(|i| FromAbove.ray_for(settings().size, f64::from(i), f64::from(i % 7) + 27.0))
        .collect();
    let bits = |color: &Color| color.channels().map(f64::to_bits);
    let world = prepared(world);
    let mut of_depths = Vec::new();
    for depth in [1, 2] {
        for omit in [true, false] {
            let tracer = RecursiveTracer::new(&world, omit);
            let mut light = vec![Color::WHITE; rays.len()];
            TracedLight { tracer, depth }.along(&rays, &mut light);
            let alone = rays.iter().map(|ray| bits(&tracer.trace(ray, depth)));
            let alone: Vec<_> = alone.collect();
            assert_eq!(light.iter().map(bits).collect::<Vec<_>>(), alone);
            of_depths.push(alone);
        }
    }
    assert!(
        of_depths[0] == of_depths[1],
        "nothing that matters is left out"
    );
    assert!(of_depths[0] != of_depths[2], "mirrored light is followed");
}
