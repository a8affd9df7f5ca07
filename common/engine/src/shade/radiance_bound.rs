//! `RadianceBound`: an upper bound of the light that any ray brings back, and the
//! reflection cutoff that follows from it.
//!
//! A surface of the colour `c` and the reflectance `k` brings back `c + k f`, where `f` is the
//! radiance of the reflected ray. So no ray brings back more than
//! `c (1 + k + k² + ..) = c / (1 - k)`, with the largest `c` and `k` of the scene. A
//! reflected ray with the throughput `m` changes the picture by less than a threshold if
//! `m c / (1 - k)` is below it. (Hall and Greenberg, A Testbed for Realistic Image Synthesis,
//! 1983: adaptive tree depth.)

use common::Color;

use super::Light;
use crate::Scene;

/// Upper bound of the radiance in a scene; infinite where a light or a material is not one of
/// the engine's, or a mirror reflects everything.
pub(crate) fn max_radiance(scene: &Scene) -> Color {
    let lights = scene.lights.iter().map(Light::max_radiance);
    let lights = lights.fold(Color::BLACK, |sum, light| sum + light);
    let (mut c, mut k) = (scene.background, Color::BLACK);
    for surface in &scene.surfaces {
        c = largest(c, surface.max_radiance(scene.ambient, lights));
        k = largest(k, surface.reflection);
    }
    // The endless sum is infinite, or NaN without mirrors: neither is below any threshold.
    c * k.map(|k| 1.0 / (1.0 - k))
}

/// Upper bound of the radiance in a scene, and the threshold of the reflection cutoff.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RadianceBound {
    /// Upper bound of the radiance in the scene.
    pub max_radiance: Color,
    /// The least light that counts, in each channel.
    pub threshold: f64,
}

impl RadianceBound {
    /// Whether reflected rays with this throughput change the picture by less than the threshold,
    /// in all channels.
    #[inline]
    pub fn cuts(&self, throughput: Color) -> bool {
        let seen = throughput * self.max_radiance;
        seen.channels()
            .iter()
            .all(|channel| *channel < self.threshold)
    }
}

fn largest(a: Color, b: Color) -> Color {
    Color::new(a.r.max(b.r), a.g.max(b.g), a.b.max(b.b))
}
