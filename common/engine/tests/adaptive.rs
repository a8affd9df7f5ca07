//! Adaptive sampling of functions of the position: the true error of a picture is at most the bound,
//! and the report of its samples is right.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

use common::{Color, Error, Image, Progress, SamplingReport, Settings, Size};
use engine::adaptive::{KnownLight, PixelRandom, render_image};
use measure::experiment::HALF_GREY_LEVEL;

/// Light at a position, counted from the middle of the lower left pixel.
type Light = fn(f64, f64) -> f64;

const BOUNDS: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, HALF_GREY_LEVEL];

/// A disc in the middle of the picture.
const DISC: Light = |x, y| {
    let (x, y) = (x - 41.3, y - 28.6);
    f64::from(u8::from(x * x + y * y < 22.2 * 22.2))
};

/// Settings for pictures of this error.
fn settings(max_error: f64, seed: u64) -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(max_error),
        seed,
        ..Settings::default()
    }
}

/// The picture and its report, if no light is brighter than `max_radiance`.
fn adaptive(
    light: impl Fn(f64, f64) -> f64 + Sync,
    max_radiance: f64,
    settings: &Settings,
) -> (Image, SamplingReport) {
    let sampled = Mutex::new(SamplingReport::default());
    let light = |x, y| Color::gray(light(x, y));
    let max_error = settings.max_error.unwrap();
    let known = KnownLight::up_to(max_radiance);
    let image = render_image(max_error, &known, &light, settings, &sampled).unwrap();
    (image, sampled.into_inner().unwrap())
}

/// The picture with `side` x `side` stratified samples per pixel.
fn stratified(light: Light, size: Size, side: u32) -> Image {
    let pixel = |column, row| {
        let random = PixelRandom::new(0x5EED, column, row);
        let sample = |i: u32| {
            let in_cell = |cell: u32, n| (f64::from(cell) + random.uniform(n)) / f64::from(side);
            let n = 2 * u64::from(i);
            let (dx, dy) = (in_cell(i % side, n), in_cell(i / side, n + 1));
            let (x, y) = (f64::from(column), f64::from(size.height() - 1 - row));
            light(x + dx - 0.5, y + dy - 0.5)
        };
        let sum: f64 = (0..side * side).map(sample).sum();
        Color::gray(sum / f64::from(side * side))
    };
    Image::from_fn(size, pixel).unwrap()
}

/// The root mean square difference of the channels as a screen shows them.
fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let shown = |color: &Color| color.r.clamp(0.0, 1.0);
    let pairs = a.pixels().iter().zip(b.pixels());
    let squares = pairs.map(|(a, b)| (shown(a) - shown(b)) * (shown(a) - shown(b)));
    (squares.sum::<f64>() / a.size().pixels() as f64).sqrt()
}

/// Checks a picture against 64 x 64 samples per pixel, and that a smaller bound takes no fewer
/// samples. Returns error and samples for the smallest bound.
fn check(light: Light) -> (f64, SamplingReport) {
    let reference = stratified(light, settings(1.0, 0).size, 64);
    let mut last = (0.0, SamplingReport::default());
    for seed in [0, 1] {
        let mut before = 0;
        for bound in BOUNDS {
            let (image, sampled) = adaptive(light, 1.0, &settings(bound, seed));
            let error = root_mean_square(&image, &reference);
            assert!(error <= bound, "{error} of {bound}, seed {seed}");
            assert!(!sampled.misses(Some(bound)), "{sampled}");
            assert!(sampled.samples >= before, "{before}; {sampled}");
            before = sampled.samples;
            last = (error, sampled);
        }
    }
    last
}

#[test]
fn a_disc_keeps_the_bound_with_a_fraction_of_the_samples() {
    let (error, sampled) = check(DISC);
    let mean = sampled.samples as f64 / sampled.pixels as f64;
    let size = Size::new(80, 60).unwrap();
    let everywhere = stratified(DISC, size, mean.sqrt().ceil() as u32);
    let uniform = root_mean_square(&everywhere, &stratified(DISC, size, 64));
    assert!(uniform > 1.5 * error, "{error}, {uniform}; {sampled}");
}

#[test]
fn edges_lines_and_highlights_keep_the_bound() {
    let lights: [Light; 4] = [
        // Edges in the very middle of the picture, between two pixels: without jitter, all
        // corners of a pixel would lie on one side.
        |x, y| f64::from(u8::from(x > 39.5 && y > 29.5)),
        // Five times as bright as white: 0.2 of a pixel makes it white, and samples that agree
        // by luck show no variance.
        |x, y| if y > 0.31 * x + 17.3 { 5.0 } else { 0.0 },
        // Thinner than a pixel, so that most middles lie beside it.
        |x, y| f64::from(u8::from((y - 0.4 * x - 12.3).abs() < 0.3)),
        |x, y| {
            let (x, y) = ((x - 40.2) / 6.0, (y - 30.7) / 4.0);
            1.4 / (1.0 + x * x + y * y)
        },
    ];
    for light in lights {
        check(light);
    }
}

/// The middle sees light that changes evenly at its mean, and so does the pair that checks it.
#[test]
fn smooth_light_takes_the_fewest_samples() {
    let slope: Light = |x, y| 0.1 + 0.002 * x + 0.003 * y;
    let settings = settings(1.0 / 64.0, 0);
    // The mean of a pixel is the light in its middle.
    let exact = |column, row| Color::gray(slope(f64::from(column), f64::from(59 - row)));
    let exact = Image::from_fn(settings.size, exact).unwrap();
    let (image, sampled) = adaptive(slope, 1.0, &settings);
    assert_eq!((sampled.most, sampled.samples), (3, 3 * sampled.pixels));
    assert!(root_mean_square(&image, &exact) < 1e-12);
}

/// A lone square of 0.3 x 0.3 pixels makes the error 0.09 / 69. Three pixels in which one of
/// the root of 3 / 0.09 samples may be wrong make its square, even if all is empty.
#[test]
fn an_empty_picture_is_searched_for_small_objects() {
    let bound = 0.09 / (80.0 * 60.0_f64).sqrt();
    let (image, sampled) = adaptive(|_, _| 0.25, 1.0, &settings(bound, 0));
    assert!(image.pixels().iter().all(|c| *c == Color::gray(0.25)));
    let needed = 3_f64.sqrt() / 0.09 * sampled.pixels as f64;
    assert!(sampled.samples as f64 >= needed, "{sampled}");
    assert!(sampled.max_error() > 0.5 * bound, "{sampled}");
}

/// With twenty seeds, a lone square is missed in a promised picture at most once; the
/// probability is below 5 % in each, and the seeds are fixed.
#[test]
fn a_lone_object_that_matters_is_found() {
    let speck: Light = |x, y| f64::from(u8::from((x - 40.2).abs().max((y - 30.1).abs()) < 0.2));
    let reference = stratified(speck, settings(1.0, 0).size, 64);
    let missed = (0..20).filter(|seed| {
        let (image, sampled) = adaptive(speck, 1.0, &settings(HALF_GREY_LEVEL, *seed));
        let above = root_mean_square(&image, &reference) > HALF_GREY_LEVEL;
        above && !sampled.misses(Some(HALF_GREY_LEVEL))
    });
    assert!(missed.count() <= 1);
}

/// Nothing brighter than a quarter is seen. The search is for objects up to the brightest light of the
/// scene, if that is at most twice as bright as white, and else up to white.
#[test]
fn the_promise_holds_up_to_the_brightest_light_that_is_possible_or_was_seen() {
    for (max_radiance, is_conditional) in [
        (0.25, false),
        (1.0, false),
        (2.0, false),
        (2.1, true),
        (40.0, true),
    ] {
        let (_, sampled) = adaptive(|_, _| 0.25, max_radiance, &settings(1.0 / 64.0, 0));
        assert_eq!(sampled.is_conditional(), is_conditional, "{sampled}");
        let searched = if is_conditional { 1.0 } else { max_radiance };
        assert_eq!(sampled.brightest, searched, "{sampled}");
    }
}

#[test]
fn the_seed_changes_the_picture() {
    let [one, two] = [0, 1].map(|seed| adaptive(DISC, 1.0, &settings(HALF_GREY_LEVEL, seed)).0);
    assert_ne!(one, two);
}

/// The report says so if the allowed samples are too few for the bound.
#[test]
fn no_pixel_takes_more_samples_than_allowed() {
    for (samples, most) in [(1, 4), (4, 4), (5, 5), (21, 21), (64, 63)] {
        let mut settings = settings(1e-5, 0);
        settings.samples = samples;
        let (_, sampled) = adaptive(DISC, 1.0, &settings);
        assert!(sampled.most <= most, "{sampled}");
        assert!(sampled.misses(Some(1e-5)), "{sampled}");
    }
}

/// Counts the samples of each pixel, also where all pixels begin with their middle, and where nothing
/// is searched outside of the square around the disc.
#[test]
fn the_reported_samples_are_those_that_were_taken() {
    for (bound, most, is_known) in [
        (1.0 / 64.0, 1024, false),
        (1.0 / 64.0, 1024, true),
        (1e-4, 6, false),
        (1e-4, 9, true),
        (HALF_GREY_LEVEL, 4, true),
    ] {
        let mut settings = settings(bound, 0);
        settings.samples = most;
        let size = settings.size;
        let taken: Vec<_> = (0..size.pixels()).map(|_| AtomicU32::new(0)).collect();
        let index = |x: f64, y: f64| (59.0 - y.round()) as usize * 80 + x.round() as usize;
        let light = |x: f64, y: f64| {
            taken[index(x, y)].fetch_add(1, Ordering::Relaxed);
            Color::gray(DISC(x, y))
        };
        let is_outside = |i: usize| {
            let [x, y] = [(i % 80) as f64 - 41.3, (59 - i / 80) as f64 - 28.6];
            x.abs().max(y.abs()) > 22.2 + 0.5
        };
        let mut known = KnownLight::up_to(1.0);
        if is_known {
            known.without_objects = (0..size.pixels()).map(is_outside).collect();
        }
        let sampled = Mutex::new(SamplingReport::default());
        render_image(bound, &known, &light, &settings, &sampled).unwrap();
        let sampled = sampled.into_inner().unwrap();
        let taken: Vec<_> = taken.into_iter().map(AtomicU32::into_inner).collect();
        assert_eq!(taken.iter().max(), Some(&sampled.most), "{sampled}");
        let samples: u64 = taken.iter().copied().map(u64::from).sum();
        assert_eq!(samples, sampled.samples, "{sampled}");
        assert!(sampled.most <= most, "{sampled}");
        for (i, taken) in taken.into_iter().enumerate() {
            assert!(!is_known || !is_outside(i) || taken == 1, "{i}: {taken}");
        }
    }
}

/// What is known may be wrong, as by a camera that is being written: a middle that is no background is
/// searched.
#[test]
fn a_pixel_with_other_light_than_the_background_is_searched() {
    let settings = settings(HALF_GREY_LEVEL, 0);
    let mut known = KnownLight::up_to(1.0);
    known.without_objects = vec![true; settings.size.pixels()];
    let light = |x, y| {
        Color::gray(if DISC(x, y) > 0.0 {
            0.1 + 0.01 * x
        } else {
            0.0
        })
    };
    let sampled = Mutex::new(SamplingReport::default());
    render_image(HALF_GREY_LEVEL, &known, &light, &settings, &sampled).unwrap();
    let sampled = sampled.into_inner().unwrap();
    assert!(
        sampled.most > 3 && sampled.samples > 2 * sampled.pixels,
        "{sampled}"
    );
}

/// All light is known, so one sample a pixel has no error.
#[test]
fn a_picture_of_background_alone_is_not_searched() {
    let settings = settings(1e-5, 0);
    let mut known = KnownLight::up_to(1.0);
    known.without_objects = vec![true; settings.size.pixels()];
    known.background = Color::gray(0.25);
    let sampled = Mutex::new(SamplingReport::default());
    render_image(1e-5, &known, &|_, _| Color::gray(0.25), &settings, &sampled).unwrap();
    let sampled = sampled.into_inner().unwrap();
    assert_eq!((sampled.samples, sampled.most), (sampled.pixels, 1));
    assert_eq!(sampled.max_error(), 0.0);
}

/// Ten specks of a tenth of a pixel, of which few samples meet one: some of their pixels need more
/// than 512 samples for this bound, and may have them.
#[test]
fn a_bound_is_given_up_only_where_no_more_samples_are_allowed() {
    let specks: Light = |x, y| {
        let is_in = |i: u32| {
            let (x, y) = (x - 7.31 * f64::from(i) - 3.2, y - 5.17 * f64::from(i) - 4.4);
            x * x + y * y < 0.05 * 0.05
        };
        f64::from(u8::from((0..10).any(is_in)))
    };
    for seed in 0..6 {
        let mut settings = settings(HALF_GREY_LEVEL, seed);
        settings.samples = 1_000_000;
        let (_, sampled) = adaptive(specks, 1.0, &settings);
        assert!(
            !sampled.misses(settings.max_error),
            "seed {seed}: {sampled}"
        );
    }
}

/// Odd sides, and fewer pixels than a block has.
#[test]
fn small_pictures_keep_the_bound_or_say_that_they_may_not() {
    for (width, height) in [(1, 1), (1, 2), (3, 1), (5, 7), (17, 33)] {
        let size = Size::new(width, height).unwrap();
        let half_plane: Light = |x, y| f64::from(u8::from(y > 0.31 * x + 0.1));
        let settings = settings(HALF_GREY_LEVEL, 0);
        let (image, sampled) = adaptive(half_plane, 1.0, &Settings { size, ..settings });
        assert_eq!(sampled.pixels, size.pixels() as u64);
        let error = root_mean_square(&image, &stratified(half_plane, size, 64));
        let misses = sampled.misses(Some(HALF_GREY_LEVEL));
        assert!(error <= HALF_GREY_LEVEL || misses, "{size}: {error}");
    }
}

#[test]
fn light_that_is_not_finite_comes_to_an_end() {
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        let half = |x, _| if x > 30.0 { bad } else { 0.0 };
        adaptive(half, f64::INFINITY, &settings(HALF_GREY_LEVEL, 0));
    }
}

/// The fractions that are told, and whether the rendering is stopped.
struct Fractions(Mutex<Vec<f64>>, bool);

impl Progress for Fractions {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}

    fn done(&self, fraction: f64) {
        self.0.lock().unwrap().push(fraction);
    }

    fn stopped(&self) -> bool {
        self.1
    }
}

#[test]
fn the_fraction_of_the_work_grows_and_stays_below_1() {
    for stopped in [false, true] {
        let fractions = Fractions(Mutex::default(), stopped);
        let (light, settings) = (|x, y| Color::gray(DISC(x, y)), settings(1.0, 0));
        let result = render_image(
            HALF_GREY_LEVEL,
            &KnownLight::up_to(1.0),
            &light,
            &settings,
            &fractions,
        );
        assert_eq!(matches!(result, Err(Error::Stopped)), stopped);
        let told = fractions.0.into_inner().unwrap();
        assert!(told.is_sorted() && told[0] == 0.0, "{told:?}");
        assert!(told.iter().all(|fraction| *fraction < 1.0), "{told:?}");
        assert!(stopped || told.len() > 3, "{told:?}");
    }
}
