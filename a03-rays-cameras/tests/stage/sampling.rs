//! Samples lie where they should, and pixels are their mean.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, OrthographicCamera, PixelRandom, Ray, Sampler, render};
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

#[test]
fn every_cell_of_the_grid_holds_one_stratified_sample() {
    let mut cells: Vec<_> = places(Sampling::Stratified, 100)
        .iter()
        .map(|(x, y)| ((x * 10.0) as u32, (y * 10.0) as u32))
        .collect();
    cells.sort_unstable();
    cells.dedup();
    assert_eq!(cells.len(), 100);
}

#[test]
fn samples_lie_in_their_pixel_and_grids_take_a_square_number() {
    for sampling in [
        Sampling::Center,
        Sampling::Regular,
        Sampling::Random,
        Sampling::Stratified,
    ] {
        for samples in [0, 1, 2, 3, 5, 16, 1000] {
            let places = places(sampling, samples);
            assert!(!places.is_empty());
            for (x, y) in &places {
                assert!((0.0..1.0).contains(x) && (0.0..1.0).contains(y));
            }
            if sampling.is_grid() {
                assert!(places.len().isqrt().pow(2) == places.len());
            }
        }
    }
}

/// The mean of n even random numbers is 1/2 with a standard deviation of
/// 1/sqrt(12 n); the seeds are fixed, the tolerance is five deviations.
#[test]
fn random_numbers_are_even_and_differ_by_seed_pixel_and_index() {
    const N: u64 = 100_000;
    let tolerance = 5.0 / (12.0 * N as f64).sqrt();
    let mean = |numbers: &dyn Fn(u64) -> f64| (0..N).map(numbers).sum::<f64>() / N as f64;
    let means = [
        mean(&|n| PixelRandom::new(0, 0, 0).uniform(n)),
        mean(&|n| PixelRandom::new(n, 0, 0).uniform(0)),
        mean(&|n| PixelRandom::new(0, n as u32, 0).uniform(0)),
        mean(&|n| PixelRandom::new(0, 0, n as u32).uniform(1)),
    ];
    for mean in means {
        assert!((mean - 0.5).abs() < tolerance, "{mean}");
    }
    // Neighbours are independent: the mean product is 1/4, deviation < 0.3/sqrt n.
    let neighbours = mean(&|n| {
        let at = |x| PixelRandom::new(0, x, 5).uniform(0);
        at(n as u32) * at(n as u32 + 1)
    });
    assert!(
        (neighbours - 0.25).abs() < 5.0 * 0.3 / (N as f64).sqrt(),
        "{neighbours}"
    );
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

fn camera() -> OrthographicCamera {
    let (e, up) = (Point3::ORIGIN, Vector3::new(0.0, 1.0, 0.0));
    OrthographicCamera::new(e, Vector3::new(0.0, 0.0, -1.0), up, 1.0).unwrap()
}

/// Linear radiance: the mean over a pixel is the value in its middle. The rays
/// of the grid are symmetric, so only rounding is left.
#[test]
fn rows_count_downwards_and_columns_rightwards() {
    let radiance = |ray: &Ray| Color::new(ray.origin().x(), ray.origin().y(), 0.0);
    for settings in [
        settings(Sampling::Center, 1),
        settings(Sampling::Regular, 16),
    ] {
        let image = render(&camera(), radiance, &settings, &()).unwrap();
        for (column, row) in [(0, 0), (7, 0), (0, 5), (2, 3)] {
            let (x, y) = (f64::from(column), f64::from(5 - row));
            let middle = camera().ray_for(settings.size, x, y).origin();
            let pixel = image.get(column, row).unwrap();
            assert!((pixel.r - middle.x()).abs() < 1e-15);
            assert!((pixel.g - middle.y()).abs() < 1e-15);
        }
        assert!(image.get(0, 0).unwrap().r < 0.0 && image.get(0, 0).unwrap().g > 0.0);
    }
}

#[test]
fn another_seed_is_another_picture_and_the_same_seed_the_same() {
    let radiance = |ray: &Ray| Color::gray(ray.origin().x());
    let with_seed = |seed| {
        let settings = Settings {
            seed,
            ..settings(Sampling::Random, 2)
        };
        render(&camera(), radiance, &settings, &()).unwrap()
    };
    assert_eq!(with_seed(1), with_seed(1));
    assert_ne!(with_seed(1), with_seed(2));
}

#[derive(Default)]
struct StopAfterThree {
    rows: AtomicU32,
    stop: AtomicBool,
}

impl Progress for StopAfterThree {
    fn row(&self, _: u32, pixels: &mut dyn Iterator<Item = Color>) {
        assert_eq!(pixels.count(), 8);
        let before = self.rows.fetch_add(1, Ordering::Relaxed);
        self.stop.store(before + 1 >= 3, Ordering::Relaxed);
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

#[test]
fn a_stopped_rendering_ends_early() {
    let progress = StopAfterThree::default();
    let one_thread = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let settings = settings(Sampling::Center, 1);
    let outcome = one_thread.install(|| render(&camera(), |_| Color::WHITE, &settings, &progress));
    assert!(matches!(outcome, Err(Error::Stopped)));
    assert_eq!(progress.rows.into_inner(), 3);
}
