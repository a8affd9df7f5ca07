//! Reports the rays from the camera, by a wrapper around the camera.

use a02_math::arrays::array;
use common::steps::{self, Step, StepKind};
use common::{Color, Size};

use crate::{Camera, Ray};

/// A camera that reports its rays.
struct InstrumentedCamera(Box<dyn Camera>);

/// Wraps this camera to report its rays.
pub fn camera(camera: Box<dyn Camera>) -> Box<dyn Camera> {
    Box::new(InstrumentedCamera(camera))
}

impl Camera for InstrumentedCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let ray = self.0.ray_for(size, x, y);
        push_ray(&ray);
        ray
    }
}

/// Reports a ray from the camera.
pub fn push_ray(ray: &Ray) {
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
