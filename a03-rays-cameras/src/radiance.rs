//! `Radiance`: what is known of the light that comes back along rays.

use common::Color;

use crate::Ray;

/// Who is asked for light. A function of some rays that fills in the light along
/// each of them is one, too.
pub trait Radiance: Sync {
    /// The light that comes back along each of some rays, neighbours mostly, for
    /// `light`: as many as there are rays.
    fn along(&self, rays: &[Ray], light: &mut [Color]);

    /// Whether something may be seen between four rays, the corners of a square, that
    /// is narrower than this share of its side. Adaptive sampling looks closer there.
    fn may_hide(&self, _corners: &[Ray; 4], _narrow: f64) -> bool {
        true
    }
}

impl<F: Fn(&[Ray], &mut [Color]) + Sync> Radiance for F {
    fn along(&self, rays: &[Ray], light: &mut [Color]) {
        self(rays, light);
    }
}
