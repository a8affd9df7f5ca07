//! The report of the samples and of the progress is right.

use std::sync::atomic::{AtomicU32, Ordering};

use common::{Error, Progress};

use super::*;

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
