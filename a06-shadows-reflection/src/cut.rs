//! `Cut`: where what a mirror shows can no longer be seen.
//!
//! A surface of the colour `c` that mirrors the share `k` brings back
//! `c + k f`, and the surface seen in it is no brighter. So no ray brings back
//! more than `c (1 + k + k² + ..) = c / (1 - k)`, with the largest `c` and `k`
//! of the world. What is mirrored to the eye by a share `m` is then below a
//! bound if `m c / (1 - k)` is.

use a05_lighting::Light;
use common::Color;

use crate::ShadowedWorld;

/// The largest of what a ray can bring back, and what nobody would see of it.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    brightest: Color,
    bound: f64,
}

impl Cut {
    /// Where less than `bound` of a channel remains to be seen of this world.
    pub fn new(world: &ShadowedWorld, bound: f64) -> Self {
        let lights = world.lights().iter().map(Light::brightest);
        let lights = lights.fold(Color::BLACK, |sum, light| sum + light);
        let ambient = world.ambient().map(f64::abs);
        let (mut c, mut k) = (world.objects().background().map(f64::abs), Color::BLACK);
        for (_, surface) in world.objects().objects() {
            c = largest(c, surface.brightest(ambient, lights));
            k = largest(k, surface.reflection());
        }
        // Without end it is infinite, or NaN where there is nothing to mirror:
        // neither is below any bound.
        let series = k.map(|k| 1.0 / (1.0 - k));
        Self {
            brightest: c * series,
            bound,
        }
    }

    /// Whether light that reaches the eye mirrored by such a share is below
    /// the bound, in all channels.
    pub fn is_due(&self, mirrored: Color) -> bool {
        let seen = mirrored * self.brightest;
        seen.channels().iter().all(|channel| *channel < self.bound)
    }

    /// What less than is not seen.
    pub const fn bound(&self) -> f64 {
        self.bound
    }
}

fn largest(a: Color, b: Color) -> Color {
    Color::new(a.r.max(b.r), a.g.max(b.g), a.b.max(b.b))
}
