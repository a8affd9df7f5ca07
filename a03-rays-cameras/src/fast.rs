//! Translates the cameras, rays and samples of this stage for the engine.

use std::any::Any;

use a02_math::{Point3, Vector3};
use common::steps::{self, StepKind};
use common::{Error, Image, Progress, Settings};

use crate::{Basis, Camera, OrthographicCamera, PerspectiveCamera, Ray, Sampler};

impl From<&Ray> for engine::Ray {
    fn from(ray: &Ray) -> Self {
        Self {
            origin: ray.origin().to_glam(),
            direction: ray.direction().to_glam(),
        }
    }
}

impl From<&engine::Ray> for Ray {
    fn from(ray: &engine::Ray) -> Self {
        let (origin, direction) = (ray.origin, ray.direction);
        Self::derived(Point3::from_glam(origin), Vector3::from_glam(direction))
    }
}

fn basis(basis: Basis) -> engine::Basis {
    engine::Basis {
        e: basis.e.to_glam(),
        u: basis.u.to_glam(),
        v: basis.v.to_glam(),
        w: basis.w.to_glam(),
    }
}

/// The engine's camera: numbers if the engine has the camera's type, otherwise a
/// function.
#[must_use]
pub fn camera(camera: &dyn Camera) -> engine::Camera<'_> {
    let any: &dyn Any = camera;
    if let Some(boxed) = any.downcast_ref::<Box<dyn Camera>>() {
        self::camera(&**boxed)
    } else if let Some(camera) = any.downcast_ref::<PerspectiveCamera>() {
        engine::Camera::Perspective {
            basis: basis(camera.basis),
            half_tangent: camera.opening.half_tangent,
        }
    } else if let Some(camera) = any.downcast_ref::<OrthographicCamera>() {
        engine::Camera::Orthographic {
            basis: basis(camera.basis),
            scale: camera.s,
        }
    } else {
        let ray_for = |size, x, y| engine::Ray::from(&camera.ray_for(size, x, y));
        engine::Camera::Other(Box::new(ray_for))
    }
}

impl engine::Sampler for Sampler {
    fn samples(&self) -> u32 {
        Self::samples(self)
    }

    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        if self.sampling.is_random() {
            steps::count(StepKind::RandomNumber, 2);
        }
        Self::place(self, i, column, row)
    }
}

/// Renders a picture with the engine.
pub(crate) fn render(
    scene: engine::Scene,
    camera: &dyn Camera,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let renderer = engine::Renderer::new(scene, self::camera(camera), settings);
    renderer.render(&Sampler::new(settings), settings, progress)
}
