//! `Material`: how a surface reflects light.

use std::any::Any;
use std::fmt::Debug;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::Lighting;

/// A material of a surface.
pub trait Material: Any + Debug + Send + Sync {
    /// The light that is reflected from the hit back along the ray.
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color;
}
