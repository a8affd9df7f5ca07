//! Samples lie where they should, and pixels are their mean.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{
    Camera, OrthographicCamera, PinholeCamera, PixelRandom, Ray, Sampler, StripeRule, StripedSky,
    render,
};
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

const ALL: [Sampling; 4] = [
    Sampling::Center,
    Sampling::Regular,
    Sampling::Random,
    Sampling::Stratified,
];

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
    for sampling in ALL {
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

#[test]
fn a_white_world_is_white_however_it_is_sampled() {
    for sampling in ALL {
        for samples in [1, 2, 3, 5, 49] {
            let settings = settings(sampling, samples);
            let image = render(&camera(), |_| Color::WHITE, &settings, &()).unwrap();
            assert!(image.pixels().iter().all(|c| *c == Color::WHITE));
        }
    }
}

/// Linear radiance: the mean over a pixel is the value in its middle. The rays
/// of the grid are symmetric, so only rounding is left.
#[test]
fn rows_count_downwards_and_columns_rightwards() {
    let radiance =
        |ray: &a03_rays_cameras::Ray| Color::new(ray.origin().x(), ray.origin().y(), 0.0);
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
    let radiance = |ray: &a03_rays_cameras::Ray| Color::gray(ray.origin().x());
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

#[test]
fn stripes_alternate_and_have_the_given_number() {
    let size = Size::SECOND_COURSE;
    for alpha in [0.5, std::f64::consts::FRAC_PI_2, 2.5] {
        let camera = PinholeCamera::new(Point3::ORIGIN, alpha).unwrap();
        for rule in [StripeRule::Direction, StripeRule::Wall] {
            for stripes in [1, 2, 3, 10, 11] {
                let sky = StripedSky::new(&camera, size, stripes, rule).unwrap();
                let column = (0..size.height()).map(|y| {
                    let ray = camera.generate_ray(size, 240.0, f64::from(y) + 0.5);
                    (sky.stripe(&ray), sky.color_for(&ray))
                });
                let mut seen: Vec<_> = column.collect();
                seen.dedup();
                let numbers: Vec<_> = seen.iter().map(|(stripe, _)| *stripe).collect();
                assert_eq!(numbers, (0..stripes).rev().collect::<Vec<_>>());
                assert!(seen.windows(2).all(|pair| pair[0].1 != pair[1].1));
            }
        }
    }
}

#[test]
fn the_stripes_of_the_wall_are_straight_and_equally_high() {
    let size = Size::new(400, 300).unwrap();
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.8).unwrap();
    let sky = StripedSky::new(&camera, size, 10, StripeRule::Wall).unwrap();
    for y in 0..300 {
        for x in [0.5, 200.0, 399.5] {
            let ray = camera.generate_ray(size, x, f64::from(y) + 0.5);
            assert_eq!(sky.stripe(&ray), 9 - y / 30);
        }
    }
}

/// On the boundary between two stripes, `d.y = c` and so the height on the
/// picture is `c / sqrt(1 - c²)` times the distance from the eye.
#[test]
fn the_stripes_of_directions_bend_along_a_hyperbola() {
    let size = Size::new(400, 300).unwrap();
    let camera = PinholeCamera::new(Point3::ORIGIN, std::f64::consts::FRAC_PI_2).unwrap();
    let sky = StripedSky::new(&camera, size, 10, StripeRule::Direction).unwrap();
    let top = 0.5_f64.sqrt();
    let c = 0.6 * top; // between stripes 7 and 8
    for x in [-200.0, -120.0, 0.0, 77.0, 200.0_f64] {
        let height = c / (1.0 - c * c).sqrt() * (x * x + 150.0 * 150.0).sqrt();
        for (beside, stripe) in [(-1e-6, 7), (1e-6, 8)] {
            let ray = camera.generate_ray(size, 200.0 + x, 150.0 - height - beside);
            assert_eq!(sky.stripe(&ray), stripe);
        }
    }
}

#[test]
fn a_level_ray_meets_the_stripe_that_begins_at_the_horizon() {
    let size = Size::SECOND_COURSE;
    for alpha in [std::f64::consts::FRAC_PI_3, std::f64::consts::FRAC_PI_2] {
        let camera = PinholeCamera::new(Point3::ORIGIN, alpha).unwrap();
        let level = camera.generate_ray(size, 240.0, 135.0);
        for rule in [StripeRule::Direction, StripeRule::Wall] {
            for stripes in 1..=1000 {
                let sky = StripedSky::new(&camera, size, stripes, rule).unwrap();
                assert_eq!(sky.stripe(&level), stripes / 2, "of {stripes}");
            }
        }
    }
}

#[test]
fn beyond_an_edge_the_stripe_at_the_edge_is_met() {
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0).unwrap();
    let size = Size::new(8, 6).unwrap();
    for rule in [StripeRule::Direction, StripeRule::Wall] {
        let sky = StripedSky::new(&camera, size, 10, rule).unwrap();
        let stripe = |y| {
            let ray = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, y, -0.1));
            sky.stripe(&ray)
        };
        assert_eq!((stripe(1.0), stripe(-1.0)), (9, 0));
    }
}

#[test]
fn a_sky_of_no_stripes_is_refused() {
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0).unwrap();
    let sky = StripedSky::new(&camera, Size::COURSE, 0, StripeRule::Wall);
    assert!(sky.unwrap_err().to_string().contains("at least 1"));
}
