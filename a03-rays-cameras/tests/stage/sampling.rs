//! Samples lie where they should, and a rendering can be stopped.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU32, Ordering};

use a02_math::Point3;
use a03_rays_cameras::{PinholeCamera, PixelRandom, Sampler, render};
use common::{Color, Error, Progress, Sampling, Settings, Size};

fn settings(sampling: Sampling, samples: u32) -> Settings {
    Settings {
        size: Size::new(8, 6).unwrap(),
        sampling,
        samples,
        ..Settings::default()
    }
}

fn places(sampling: Sampling, samples: u32) -> Vec<(f64, f64)> {
    Sampler::new(&settings(sampling, samples))
        .places(3, 2)
        .collect()
}

#[test]
fn center_and_regular_grids_have_exact_places() {
    assert_eq!(places(Sampling::Center, 9), [(0.5, 0.5)]);
    assert_eq!(places(Sampling::Regular, 1), [(0.5, 0.5)]);
    let expected = [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)];
    assert_eq!(places(Sampling::Regular, 4), expected);
}

/// In a grid of a square number of cells, each holds one sample.
#[test]
fn samples_lie_in_their_pixel_and_in_all_cells() {
    for sampling in [
        Sampling::Center,
        Sampling::Regular,
        Sampling::Random,
        Sampling::Stratified,
    ] {
        for samples in [0, 1, 2, 3, 5, 16, 100, 1000] {
            let places = places(sampling, samples);
            let side = places.len().isqrt();
            let cell = |x: f64| (x * side as f64).floor();
            let mut cells = HashSet::new();
            for (x, y) in &places {
                assert!((0.0..1.0).contains(x) && (0.0..1.0).contains(y));
                cells.insert([cell(*x), cell(*y)].map(f64::to_bits));
            }
            assert!(!places.is_empty());
            if sampling.is_grid() {
                assert_eq!((cells.len(), places.len()), (side * side, side * side));
            }
        }
    }
}

/// The mean of n even random numbers is 1/2 with a standard deviation of
/// 1/sqrt(12 n); the seeds are fixed, the tolerance is five deviations.
#[test]
fn random_numbers_are_even_and_differ_by_seed_pixel_and_index() {
    const N: u64 = 100_000;
    let deviation = 1.0 / (12.0 * N as f64).sqrt();
    let mean = |numbers: &dyn Fn(u64) -> f64| (0..N).map(numbers).sum::<f64>() / N as f64;
    for mean in [
        mean(&|n| PixelRandom::new(0, 0, 0).uniform(n)),
        mean(&|n| PixelRandom::new(n, 0, 0).uniform(0)),
        mean(&|n| PixelRandom::new(0, n as u32, 0).uniform(0)),
        mean(&|n| PixelRandom::new(0, 0, n as u32).uniform(1)),
    ] {
        assert!((mean - 0.5).abs() < 5.0 * deviation, "{mean}");
    }
    // Neighbours are independent: the mean product is 1/4, with a deviation below this one.
    let at = |x| PixelRandom::new(0, x, 5).uniform(0);
    let product = mean(&|n| at(n as u32) * at(n as u32 + 1));
    assert!((product - 0.25).abs() < 5.0 * deviation, "{product}");
}

/// A number that two samples share would put them in a line.
#[test]
fn no_two_coordinates_of_random_samples_are_the_same_number() {
    let places = places(Sampling::Random, 1000);
    let mut numbers: Vec<_> = places.into_iter().flat_map(|(x, y)| [x, y]).collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    assert_eq!(numbers.len(), 2000);
}

#[test]
fn another_seed_gives_other_samples() {
    let with_seed = |seed| {
        let settings = settings(Sampling::Random, 2);
        Sampler::new(&Settings { seed, ..settings }).place(0, 3, 2)
    };
    assert_ne!(with_seed(1), with_seed(2));
}

/// The number of finished rows; three are enough.
struct ThreeRows(AtomicU32);

impl Progress for ThreeRows {
    fn row(&self, _: u32, pixels: &mut dyn Iterator<Item = Color>) {
        assert_eq!(pixels.count(), 8);
        self.0.fetch_add(1, Ordering::Relaxed);
    }

    fn stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed) >= 3
    }
}

#[test]
fn a_stopped_rendering_ends_early() {
    let rows = ThreeRows(AtomicU32::new(0));
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0).unwrap();
    let settings = settings(Sampling::Center, 1);
    let rendering = || render(&camera, |_| Color::WHITE, &settings, &rows);
    let outcome = one_thread.unwrap().install(rendering);
    assert!(matches!(outcome, Err(Error::Stopped)));
    assert_eq!(rows.0.into_inner(), 3);
}
