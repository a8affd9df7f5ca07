//! Adaptive sampling keeps what it promises, and says what it took.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, NestedSamples, PixelRandom, Ray, render};
use common::experiment::HALF_GREY_LEVEL;
use common::{Color, Image, Progress, Sampled, Sampling, Scene, Settings, Size};

/// Rays that start at their place in the picture, in pixels.
struct Places;

impl Camera for Places {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::new(x, y, 0.0), Vector3::new(0.0, 0.0, -1.0))
    }
}

/// A scene that is a function of the place, in pixels from the lower left.
fn drawn(light: fn(f64, f64) -> f64) -> Scene {
    Scene::traced("drawn", "", move |settings, progress| {
        let light = |ray: &Ray| Color::gray(light(ray.origin().x(), ray.origin().y()));
        render(&Places, light, settings, progress)
    })
}

/// Counts rows.
#[derive(Default)]
struct Listener {
    announced: AtomicU32,
    painted: AtomicU32,
}

impl Progress for Listener {
    fn row(&self, _: u32, _: &[Color]) {
        self.painted.fetch_add(1, Ordering::Relaxed);
    }

    fn more_rows(&self, rows: u32) {
        self.announced.fetch_add(rows, Ordering::Relaxed);
    }
}

fn settings(max_error: f64) -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(max_error),
        ..Settings::default()
    }
}

fn adaptive(scene: &Scene, settings: &Settings) -> (Image, Sampled) {
    let told = Mutex::new(Sampled::default());
    let image = scene.render(settings, &told).unwrap();
    (image, told.into_inner().unwrap())
}

fn stratified(scene: &Scene, side: u32, seed: u64) -> Image {
    let settings = Settings {
        samples: side * side,
        sampling: Sampling::Stratified,
        max_error: None,
        seed,
        ..settings(1.0)
    };
    scene.render(&settings, &()).unwrap()
}

/// Of the channels as a screen shows them.
fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let channels = |image: &Image| -> Vec<f64> {
        let shown = |color: &Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
        image.pixels().iter().flat_map(shown).collect()
    };
    let (a, b) = (channels(a), channels(b));
    let squares = a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

const ASKED: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, HALF_GREY_LEVEL];

/// Checks a scene against 64 x 64 samples a pixel of another seed. Returns how
/// many were taken for the smallest error.
fn check(scene: &Scene) -> Sampled {
    let reference = stratified(scene, 64, 0x5EED);
    let mut last = Sampled::default();
    for asked in ASKED {
        for seed in [0, 1] {
            let settings = Settings {
                seed,
                ..settings(asked)
            };
            let (image, sampled) = adaptive(scene, &settings);
            let error = root_mean_square(&image, &reference);
            assert!(error <= asked, "{error} of {asked}, seed {seed}");
            assert!(sampled.error() <= asked, "{sampled}");
            last = sampled;
        }
    }
    last
}

#[test]
fn striped_skies_are_as_exact_as_was_asked_for() {
    for scene in &a03_rays_cameras::stage().scenes {
        check(scene);
    }
}

/// Rows 20 to 39 of 60: the band comes to the bound by itself.
#[test]
fn a_band_of_rows_is_as_exact_too() {
    let disc = drawn(|x, y| f64::from(u8::from(in_disc(x, y))));
    let band = |image: &Image| {
        let size = Size::new(80, 20).unwrap();
        Image::from_fn(size, |x, y| image.get(x, 20 + y).unwrap()).unwrap()
    };
    let reference = band(&stratified(&disc, 64, 0x5EED));
    for asked in ASKED {
        let settings = Settings {
            rows: Some(20..40),
            ..settings(asked)
        };
        let (image, sampled) = adaptive(&disc, &settings);
        assert_eq!(sampled.pixels, 80 * 20);
        let error = root_mean_square(&image, &reference);
        assert!(error <= asked, "{error} of {asked}");
    }
}

fn in_disc(x: f64, y: f64) -> bool {
    let (x, y) = (x - 41.3, y - 28.6);
    x * x + y * y < 22.2 * 22.2
}

#[test]
fn a_disc_is_and_takes_a_fraction_of_the_samples() {
    let disc = drawn(|x, y| f64::from(u8::from(in_disc(x, y))));
    let sampled = check(&disc);
    let reference = stratified(&disc, 64, 0x5EED);
    let everywhere = root_mean_square(&stratified(&disc, 8, 0), &reference);
    assert!(everywhere > HALF_GREY_LEVEL, "{everywhere}");
    let mean = sampled.samples as f64 / sampled.pixels as f64;
    assert!(mean < 64.0 / 4.0, "{mean} samples a pixel");
}

/// Five times as bright as white: 0.2 of a pixel makes it white, and samples
/// that agree by luck show no doubt.
#[test]
fn a_glaring_half_plane_is() {
    check(&drawn(|x, y| if y > 0.31 * x + 17.3 { 5.0 } else { 0.0 }));
}

/// Thinner than a pixel, so that most middles lie beside it.
#[test]
fn a_thin_line_is() {
    check(&drawn(|x, y| {
        let across = y - 0.4 * x - 12.3;
        if across.abs() < 0.3 { 1.0 } else { 0.0 }
    }));
}

#[test]
fn a_highlight_is() {
    check(&drawn(|x, y| {
        let (x, y) = ((x - 40.2) / 6.0, (y - 30.7) / 4.0);
        1.4 / (1.0 + x * x + y * y)
    }));
}

#[test]
fn smooth_light_takes_one_sample_a_pixel() {
    let slope = drawn(|x, y| 0.1 + 0.002 * x + 0.003 * y);
    for asked in ASKED {
        let (_, sampled) = adaptive(&slope, &settings(asked));
        assert_eq!((sampled.samples, sampled.most), (80 * 60, 1));
    }
    let (image, sampled) = adaptive(&drawn(|_, _| 0.3), &settings(1e-9));
    assert_eq!(sampled.samples, 80 * 60);
    assert_eq!(sampled.error(), 0.0);
    assert!(image.pixels().iter().all(|c| *c == Color::gray(0.3)));
}

/// What lies between all middles cannot be found: this is the limit of the
/// method, and its estimate does not see it either.
#[test]
fn what_lies_between_the_middles_of_pixels_is_missing() {
    let speck = drawn(|x, y| {
        let (x, y) = (x - 40.5, y - 30.5);
        if x * x + y * y < 0.25 { 1.0 } else { 0.0 }
    });
    let (image, sampled) = adaptive(&speck, &settings(HALF_GREY_LEVEL));
    assert_eq!(sampled.error(), 0.0);
    let error = root_mean_square(&image, &stratified(&speck, 64, 0x5EED));
    assert!(error > HALF_GREY_LEVEL, "{error}");
}

#[test]
fn threads_do_not_change_it_and_the_seed_does() {
    let disc = drawn(|x, y| f64::from(u8::from(in_disc(x, y))));
    let [one, two] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| adaptive(&disc, &settings(HALF_GREY_LEVEL)))
    });
    assert_eq!(one, two);
    let other = Settings {
        seed: 1,
        ..settings(HALF_GREY_LEVEL)
    };
    assert_ne!(one.0, adaptive(&disc, &other).0);
}

#[test]
fn no_pixel_takes_more_samples_than_allowed() {
    let disc = drawn(|x, y| f64::from(u8::from(in_disc(x, y))));
    let asked = [1e-3, 1e-3, 1e-3, 1e-3, 1e-300];
    let limits = [(1, 1), (3, 1), (4, 4), (21, 16), (32, 32)];
    for (asked, (samples, most)) in asked.into_iter().zip(limits) {
        let few = Settings {
            samples,
            ..settings(asked)
        };
        let (_, sampled) = adaptive(&disc, &few);
        assert_eq!(sampled.most, most);
        assert!(sampled.error() > asked, "{sampled}");
    }
}

#[test]
fn rows_are_announced_before_they_are_painted_again() {
    let disc = drawn(|x, y| f64::from(u8::from(in_disc(x, y))));
    let listener = Listener::default();
    disc.render(&settings(HALF_GREY_LEVEL), &listener).unwrap();
    let announced = listener.announced.into_inner();
    assert!(announced > 0);
    assert_eq!(listener.painted.into_inner(), 60 + announced);
}

#[test]
fn light_that_is_no_number_ends_too() {
    for bad in [f64::NAN, f64::INFINITY] {
        let half = move |ray: &Ray| {
            Color::gray(if in_disc(ray.origin().x(), 30.0) {
                bad
            } else {
                0.0
            })
        };
        let image = render(&Places, half, &settings(HALF_GREY_LEVEL), &()).unwrap();
        assert!(image.count_non_finite() > 0);
    }
}

/// Each box of the area 2^-k holds one of the first 2^k places.
#[test]
fn nested_samples_are_evenly_spread_at_every_power_of_two() {
    for set in 0..8 {
        let samples = NestedSamples::new(&PixelRandom::new(3, 5, 7), set);
        for k in 0..=10 {
            for i in 0..=k {
                let (wide, high) = (1_u32 << i, 1_u32 << (k - i));
                let mut boxes: Vec<_> = (0..1 << k)
                    .map(|index| {
                        let (x, y) = samples.place(index);
                        ((x * f64::from(wide)) as u32, (y * f64::from(high)) as u32)
                    })
                    .collect();
                boxes.sort_unstable();
                boxes.dedup();
                assert_eq!(boxes.len(), 1 << k, "{wide} x {high} boxes");
            }
        }
    }
}
