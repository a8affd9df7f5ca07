//! Which materials have a highlight, and which lights make it compute a power.

use std::any::Any;

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::{Illumination, Phong};

/// The material as a Phong material, if it is one.
pub fn as_phong(material: &dyn Any) -> Option<&Phong> {
    material.downcast_ref()
}

/// Whether a Phong material computes a power for this light: Phong's condition.
pub fn takes_power(phong: &Phong, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let (e, l) = (-ray.direction(), light.direction);
    let is_mirrored = hit.normal.dot(l) > 0.0 && e.dot(l.reflected_on(hit.normal)) > 0.0;
    is_mirrored && phong.specular != Color::BLACK
}
