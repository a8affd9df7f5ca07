//! Counts primary rays and random numbers, and records the rays, by a wrapper around the camera.

use a02_math::arrays::array;
use std::hint::black_box;

use common::steps::{self, RAY, Step};
use common::tally::{self, Work};
use common::{Settings, Size};

use crate::{Camera, PixelRandom, Ray};

/// A camera that counts its rays and the random numbers for their places.
struct Watched {
    camera: Box<dyn Camera>,
    /// The random numbers of a ray.
    numbers: u64,
    /// Draws the numbers that a fixed place does not need.
    unneeded: Option<PixelRandom>,
}

/// Wraps this camera to count the work of a rendering with these settings. With `all_work`
/// it draws two random numbers for samples with a fixed place, too.
pub fn camera(camera: Box<dyn Camera>, settings: &Settings, all_work: bool) -> Box<dyn Camera> {
    let is_random = settings.sampling.is_random();
    Box::new(Watched {
        camera,
        numbers: if is_random || all_work { 2 } else { 0 },
        unneeded: (all_work && !is_random).then(|| PixelRandom::new(settings.seed, 0, 0)),
    })
}

impl Camera for Watched {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        tally::count(Work::PrimaryRay);
        tally::count_all(Work::RandomNumber, self.numbers);
        if let Some(random) = &self.unneeded {
            for n in 0..2 {
                // The compiler would remove numbers that are not used.
                black_box(random.uniform(black_box(n)));
            }
        }
        let ray = self.camera.ray_for(size, x, y);
        push_ray(&ray);
        ray
    }
}

/// Records a ray from the camera.
pub fn push_ray(ray: &Ray) {
    let section = "a03-rays-cameras.md#the-ray";
    steps::heading(|| ray_step(RAY, "ray from the camera", section, ray));
}

/// A step with the origin and the direction of a ray.
pub fn ray_step(
    kind: &'static str,
    name: impl Into<String>,
    section: &'static str,
    ray: &Ray,
) -> Step {
    Step::new(kind, name, section)
        .with("o", array(ray.origin()))
        .with("d", array(ray.direction()))
}
