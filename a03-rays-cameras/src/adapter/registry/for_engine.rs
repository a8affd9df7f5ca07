//! Rays, samples and cameras of this stage in the types of the engine.

use a02_math::{Point3, Vector3};
use common::{Color, Error, Image, Progress, Settings};

use crate::{Basis, Camera, Ray, Sampler};

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

impl From<Basis> for engine::Basis {
    fn from(basis: Basis) -> Self {
        Self {
            e: basis.e.to_glam(),
            u: basis.u.to_glam(),
            v: basis.v.to_glam(),
            w: basis.w.to_glam(),
        }
    }
}

/// The engine's camera: numbers if the camera's type has a row, otherwise a function.
#[must_use]
pub fn camera(camera: &dyn Camera) -> engine::Camera<'_> {
    if let Some(known) = super::kind(camera) {
        return known.for_engine();
    }
    let ray_for = |size, x, y| engine::Ray::from(&camera.ray_for(size, x, y));
    engine::Camera::Other(Box::new(ray_for))
}

impl engine::Sampler for Sampler {
    fn samples(&self) -> u32 {
        Self::samples(self)
    }

    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        Self::place(self, i, column, row)
    }
}

/// Renders a picture with the engine.
pub fn render(
    scene: engine::Scene,
    camera: &dyn Camera,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let renderer = engine::Renderer::new(scene, self::camera(camera), settings);
    renderer.render(&Sampler::new(settings), settings, progress)
}

/// The light that the engine finds at camera coordinates.
pub fn light_at<'a>(
    scene: engine::Scene<'a>,
    camera: &'a dyn Camera,
    settings: &'a Settings,
) -> impl Fn(f64, f64) -> Color + 'a {
    let renderer = engine::Renderer::new(scene, self::camera(camera), settings);
    move |x, y| renderer.light_at(settings, (x, y))
}
