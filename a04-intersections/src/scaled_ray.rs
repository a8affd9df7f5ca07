//! `hit_of_scaled_ray`: rays whose direction is so long or so short that products of its
//! coordinates would be infinite or 0.

use std::ops::RangeInclusive;

use a02_math::Vector3;
use a03_rays_cameras::Ray;

use crate::{Geometry, Hit, Interval};

/// Squared lengths of directions from which formulas of shapes may compute as they are.
pub const SQUARED_LENGTHS: RangeInclusive<f64> = 1e-40..=1e40;

/// The hit of a shape by the ray with its direction divided by a power of two, which rounds
/// nothing: the greatest coordinate is then at least 1 and below 2. `None` without a direction.
#[must_use]
pub fn hit_of_scaled_ray(shape: &impl Geometry, ray: &Ray, within: Interval) -> Option<Hit> {
    let direction = ray.direction().scaled()?;
    let largest = |d: Vector3| d.to_glam().abs().max_element();
    let unit = largest(ray.direction()) / largest(direction);
    // A direction that is shorter by this factor takes more of its lengths to the hit.
    let scaled_within = Interval {
        min: within.min * unit,
        max: within.max * unit,
    };
    let hit = shape.hit(&Ray::derived(ray.origin(), direction), scaled_within)?;
    let t = hit.t / unit;
    within.contains(t).then_some(Hit { t, ..hit })
}
