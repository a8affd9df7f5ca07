//! Counts primary rays and random numbers, by a wrapper around the camera.

use common::tally::{self, Work};
use common::{Settings, Size};

use crate::{Camera, Ray};

/// A camera that counts its rays, and two random numbers for each if sampling is
/// random.
struct Counted {
    camera: Box<dyn Camera>,
    random_numbers: u64,
}

/// Wraps this camera to count the work of a rendering with these settings.
pub fn camera(camera: Box<dyn Camera>, settings: &Settings) -> Box<dyn Camera> {
    Box::new(Counted {
        camera,
        random_numbers: if settings.sampling.is_random() { 2 } else { 0 },
    })
}

impl Camera for Counted {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        tally::count(Work::PrimaryRay);
        tally::count_all(Work::RandomNumber, self.random_numbers);
        self.camera.ray_for(size, x, y)
    }
}
