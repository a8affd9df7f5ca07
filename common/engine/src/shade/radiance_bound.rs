//! `RadianceBound`: an upper bound of the light that any ray brings back, and the
//! reflection cutoff that follows from it.
//!
//! A surface of the colour `c` that mirrors the share `k` brings back `c + k f`, and
//! the surface seen in it is no brighter. So no ray brings back more than
//! `c (1 + k + k² + ..) = c / (1 - k)`, with the largest `c` and `k` of the scene. A
//! reflected ray whose light reaches the eye by a share `m` changes the picture by less
//! than a threshold if `m c / (1 - k)` is below it. (Hall and Greenberg, A Testbed for
//! Realistic Image Synthesis, 1983: adaptive tree depth.)

use common::Color;

use super::{Light, Surface};

/// The brightest light of a scene, and the threshold of the reflection cutoff.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RadianceBound {
    brightest: Color,
    threshold: f64,
}

impl RadianceBound {
    /// The cutoff below `threshold` for a scene.
    pub fn new(
        background: Color,
        ambient: Color,
        lights: &[Light],
        surfaces: &[Surface],
        threshold: f64,
    ) -> Self {
        let lights = lights.iter().map(Light::max_radiance);
        let lights = lights.fold(Color::BLACK, |sum, light| sum + light);
        let (mut c, mut k) = (background, Color::BLACK);
        for surface in surfaces {
            c = largest(c, surface.max_radiance(ambient, lights));
            k = largest(k, surface.reflection);
        }
        // The endless sum is infinite, or NaN without mirrors: neither is below any
        // threshold.
        let series = k.map(|k| 1.0 / (1.0 - k));
        Self {
            brightest: c * series,
            threshold,
        }
    }

    /// Whether light that reaches the eye by this share is below the threshold, in all
    /// channels.
    #[inline]
    pub fn cuts(&self, share: Color) -> bool {
        let seen = share * self.brightest;
        seen.channels()
            .iter()
            .all(|channel| *channel < self.threshold)
    }
}

fn largest(a: Color, b: Color) -> Color {
    Color::new(a.r.max(b.r), a.g.max(b.g), a.b.max(b.b))
}
