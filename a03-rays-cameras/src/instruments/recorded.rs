//! Reports the rays from the camera and the random numbers for their samples, by a wrapper around
//! the camera.

use a02_math::arrays::array;
use common::steps::{self, Step, StepKind};
use common::{Color, Omission, Settings, Size};

use super::Instruments;
use crate::{Camera, PixelRandom, Ray};

/// A camera that reports its rays and the random numbers for their positions.
struct RecordedCamera {
    camera: Box<dyn Camera>,
    /// Whether a position takes random numbers.
    is_random: bool,
    /// Whether fixed positions are moved, too: by two random numbers, times 0.
    moves_fixed: bool,
    seed: u64,
}

/// Wraps this camera to report the work of a rendering with these settings. If random
/// numbers are not left out, it draws two for samples with a fixed position, too.
pub fn camera(
    camera: Box<dyn Camera>,
    settings: &Settings,
    instruments: Instruments,
) -> Box<dyn Camera> {
    let omissions = instruments.omissions();
    let is_random = settings.sampling.is_random();
    Box::new(RecordedCamera {
        camera,
        is_random,
        moves_fixed: !is_random && !omissions.contains(Omission::RandomNumbers),
        seed: settings.seed,
    })
}

impl Camera for RecordedCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let ray = if self.moves_fixed {
            let random = PixelRandom::new(self.seed, x as u32, y as u32);
            let (dx, dy) = (random.uniform(0), random.uniform(1));
            self.camera.ray_for(size, x + 0.0 * dx, y + 0.0 * dy)
        } else {
            self.camera.ray_for(size, x, y)
        };
        if self.moves_fixed || self.is_random {
            steps::count(StepKind::RandomNumber, 2);
        }
        push_ray(&ray);
        ray
    }
}

/// Reports a ray from the camera.
pub fn push_ray(ray: &Ray) {
    steps::expect_ray(None);
    steps::heading(StepKind::CameraRay, |kind| {
        ray_step(
            kind,
            "ray from the camera",
            "a03-rays-cameras.md#the-ray",
            ray,
        )
    });
}

/// Reports the number of the stripe that a ray hits, and its colour.
pub fn push_stripe(stripe: u32, color: Color) {
    steps::push(StepKind::Color, |kind| {
        let section = "a03-rays-cameras.md#the-striped-sky";
        Step::new(kind, "colour of the stripe", section)
            .with("number", [f64::from(stripe)])
            .with("c", color.channels())
    });
}

/// A step with the origin and the direction of a ray.
pub fn ray_step(kind: StepKind, name: impl Into<String>, section: &'static str, ray: &Ray) -> Step {
    Step::new(kind, name, section)
        .with("o", array(ray.origin()))
        .with("d", array(ray.direction()))
}
