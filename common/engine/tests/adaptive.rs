//! Adaptive sampling of functions of the place: the true error of a picture is at most
//! the bound, and the report of its samples is right.

mod support;

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

use common::{Color, Error, Image, Progress, Sampled, Settings, Size};
use engine::adaptive::render_image;
use measure::experiment::HALF_GREY_LEVEL;

use support::{root_mean_square, settings};

/// Light at a place, counted from the middle of the lower left pixel.
type Light = fn(f64, f64) -> f64;

const BOUNDS: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, HALF_GREY_LEVEL];

/// A disc in the middle of the picture.
const DISC: Light = |x, y| {
    let (x, y) = (x - 41.3, y - 28.6);
    f64::from(u8::from(x * x + y * y < 22.2 * 22.2))
};

fn adaptive(light: Light, settings: &Settings) -> (Image, Sampled) {
    let sampled = Mutex::new(Sampled::default());
    let light = |x, y| Color::gray(light(x, y));
    let max_error = settings.max_error.unwrap();
    let image = render_image(max_error, light, settings, &sampled).unwrap();
    (image, sampled.into_inner().unwrap())
}

fn stratified(light: Light, size: Size, side: u32) -> Image {
    support::stratified(|x, y| Color::gray(light(x, y)), size, side)
}

/// Checks a picture against 64 x 64 samples a pixel. Returns the samples taken for the
/// smallest error.
fn check(light: Light) -> Sampled {
    let reference = stratified(light, settings(1.0).size, 64);
    let mut last = Sampled::default();
    for bound in BOUNDS {
        for seed in [0, 1] {
            let settings = Settings {
                seed,
                ..settings(bound)
            };
            let (image, sampled) = adaptive(light, &settings);
            let error = root_mean_square(&image, &reference);
            assert!(error <= bound, "{error} of {bound}, seed {seed}");
            assert!(sampled.error() <= bound, "{sampled}");
            last = sampled;
        }
    }
    last
}

#[test]
fn a_disc_keeps_the_bound_with_a_fraction_of_the_samples() {
    let sampled = check(DISC);
    let size = settings(1.0).size;
    let everywhere = stratified(DISC, size, 8);
    let error = root_mean_square(&everywhere, &stratified(DISC, size, 64));
    assert!(error > HALF_GREY_LEVEL, "{error}");
    let mean = sampled.samples as f64 / sampled.pixels as f64;
    assert!(mean < 64.0 / 4.0, "{mean} samples a pixel");
}

/// Edges in the very middle of the picture, between two pixels: without jitter, all
/// corners of a pixel would lie on one side.
#[test]
fn a_quarter_whose_edges_lie_between_pixels_keeps_the_bound() {
    check(|x, y| f64::from(u8::from(x > 39.5 && y > 29.5)));
}

/// Five times as bright as white: 0.2 of a pixel makes it white, and samples that agree
/// by luck show no doubt.
#[test]
fn a_glaring_half_plane_keeps_the_bound() {
    check(|x, y| if y > 0.31 * x + 17.3 { 5.0 } else { 0.0 });
}

/// Thinner than a pixel, so that most middles lie beside it.
#[test]
fn a_thin_line_keeps_the_bound() {
    check(|x, y| {
        let across = y - 0.4 * x - 12.3;
        if across.abs() < 0.3 { 1.0 } else { 0.0 }
    });
}

#[test]
fn a_highlight_keeps_the_bound() {
    check(|x, y| {
        let (x, y) = ((x - 40.2) / 6.0, (y - 30.7) / 4.0);
        1.4 / (1.0 + x * x + y * y)
    });
}

/// Rows 20 to 39 of 60: the band comes to the bound by itself.
#[test]
fn a_band_of_rows_keeps_the_bound() {
    let band = |image: &Image| {
        let size = Size::new(80, 20).unwrap();
        Image::from_fn(size, |x, y| image.get(x, 20 + y).unwrap()).unwrap()
    };
    let reference = band(&stratified(DISC, settings(1.0).size, 64));
    for bound in BOUNDS {
        let settings = Settings {
            rows: Some(20..40),
            ..settings(bound)
        };
        let (image, sampled) = adaptive(DISC, &settings);
        assert_eq!(sampled.pixels, 80 * 20);
        let error = root_mean_square(&image, &reference);
        assert!(error <= bound, "{error} of {bound}");
    }
}

/// Neighbouring pixels share their corners.
#[test]
fn smooth_light_takes_about_one_sample_a_pixel() {
    let slope: Light = |x, y| 0.1 + 0.002 * x + 0.003 * y;
    // The mean of a pixel is the light in its middle.
    let exact = Image::from_fn(settings(1.0).size, |column, row| {
        Color::gray(slope(f64::from(column), f64::from(59 - row)))
    });
    let exact = exact.unwrap();
    for bound in BOUNDS {
        let (image, sampled) = adaptive(slope, &settings(bound));
        assert_eq!(sampled.most, 1);
        assert!(sampled.samples < sampled.pixels * 11 / 10, "{sampled}");
        assert!(root_mean_square(&image, &exact) < 1e-5);
    }
    let (image, sampled) = adaptive(|_, _| 0.3, &settings(1e-9));
    assert_eq!((sampled.most, sampled.error()), (1, 0.0));
    assert!(image.pixels().iter().all(|c| *c == Color::gray(0.3)));
}

/// This is the limit of the method, and its estimate does not see it either.
#[test]
fn an_object_between_the_corners_of_pixels_is_missed() {
    let speck: Light = |x, y| {
        let (x, y) = (x - 40.0, y - 30.0);
        if x * x + y * y < 0.25 { 1.0 } else { 0.0 }
    };
    let settings = settings(HALF_GREY_LEVEL);
    let (image, sampled) = adaptive(speck, &settings);
    assert_eq!(sampled.error(), 0.0);
    let error = root_mean_square(&image, &stratified(speck, settings.size, 64));
    assert!(error > HALF_GREY_LEVEL, "{error}");
}

#[test]
fn threads_do_not_change_the_picture_and_the_seed_does() {
    let [one, two] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| adaptive(DISC, &settings(HALF_GREY_LEVEL)))
    });
    assert_eq!(one, two);
    let other = Settings {
        seed: 1,
        ..settings(HALF_GREY_LEVEL)
    };
    assert_ne!(one.0, adaptive(DISC, &other).0);
}

/// The smallest cells are halves, quarters and eighths of a pixel wide.
#[test]
fn no_pixel_takes_more_samples_than_allowed() {
    for (samples, most) in [(1, 1), (3, 1), (4, 4), (21, 16), (64, 64)] {
        let few = Settings {
            samples,
            ..settings(1e-5)
        };
        let (_, sampled) = adaptive(DISC, &few);
        assert_eq!(sampled.most, most);
        assert!(sampled.error() > 1e-5, "{sampled}");
    }
}

/// Odd sides, and fewer pixels than a block has.
#[test]
fn small_pictures_keep_the_bound() {
    for (width, height) in [(1, 1), (1, 2), (3, 1), (5, 7), (17, 33)] {
        let size = Size::new(width, height).unwrap();
        let half_plane: Light = |x, y| f64::from(u8::from(y > 0.31 * x + 0.1));
        let small = Settings {
            size,
            ..settings(HALF_GREY_LEVEL)
        };
        let (image, sampled) = adaptive(half_plane, &small);
        assert_eq!(sampled.pixels, size.pixels() as u64);
        let error = root_mean_square(&image, &stratified(half_plane, size, 64));
        assert!(error <= HALF_GREY_LEVEL, "{size}: {error}");
    }
}

#[test]
fn light_that_is_not_finite_comes_to_an_end() {
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        let half = |x, _| Color::gray(if DISC(x, 30.0) > 0.0 { bad } else { 0.0 });
        let settings = settings(HALF_GREY_LEVEL);
        let image = render_image(HALF_GREY_LEVEL, half, &settings, &()).unwrap();
        assert_eq!(image.size(), settings.size);
    }
}

/// Counts rows.
#[derive(Default)]
struct Listener {
    announced: AtomicU32,
    painted: AtomicU32,
    stopped: bool,
}

impl Progress for Listener {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {
        self.painted.fetch_add(1, Ordering::Relaxed);
    }

    fn more_rows(&self, rows: u32) {
        self.announced.fetch_add(rows, Ordering::Relaxed);
    }

    fn stopped(&self) -> bool {
        self.stopped
    }
}

#[test]
fn rows_are_announced_before_they_are_painted_again() {
    let (listener, settings) = (Listener::default(), settings(HALF_GREY_LEVEL));
    let light = |x, y| Color::gray(DISC(x, y));
    render_image(HALF_GREY_LEVEL, light, &settings, &listener).unwrap();
    let announced = listener.announced.into_inner();
    assert!(announced > 0);
    assert_eq!(listener.painted.into_inner(), 60 + announced);
}

#[test]
fn a_stopped_rendering_is_an_error() {
    let stopped = true;
    let listener = Listener {
        stopped,
        ..Listener::default()
    };
    let light = |x, y| Color::gray(DISC(x, y));
    let result = render_image(HALF_GREY_LEVEL, light, &settings(1.0), &listener);
    assert!(matches!(result, Err(Error::Stopped)));
}
