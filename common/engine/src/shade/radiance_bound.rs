//! `RadianceBound`: an upper bound of the light that any ray brings back, and the
//! reflection cutoff that follows from it.
//!
//! A surface of the colour `c` and the reflectance `k` brings back `c + k f`, where `f` is the
//! radiance of the reflected ray. A path meets at most `depth` surfaces, and shows the background
//! only instead of one of them. So with the largest `c` and `k` of the scene, the background's
//! colour included, no ray brings back more than
//! `c (1 + k + .. + k^(depth - 1)) = c (1 - k^depth) / (1 - k)`, or `c depth` for `k = 1`. With one
//! surface only, that is `c`.
//!
//! The `c` of a material bounds its highlights as well: no cosine, and no power of one, is above 1.
//! So each light adds at most its own colour times the diffuse and the specular reflectance.
//!
//! A reflected ray with the throughput `m` has fewer surfaces left, and changes the picture by less
//! than a threshold if `m` times that bound is below it. (Hall and Greenberg, A Testbed for
//! Realistic Image Synthesis, 1983: adaptive tree depth.)

use common::Color;

use super::Light;
use crate::Scene;

/// Upper bound of the radiance in a scene; infinite where a light or a material is not one of
/// the engine's.
pub(crate) fn max_radiance(scene: &Scene) -> Color {
    let lights = scene.lights.iter().map(Light::max_radiance);
    let lights = lights.fold(Color::BLACK, |sum, light| sum + light);
    let (mut c, mut k) = (scene.background, Color::BLACK);
    for surface in &scene.surfaces {
        c = largest(c, surface.max_radiance(scene.ambient, lights));
        k = largest(k, surface.reflection);
    }
    c * k.map(|k| geometric_sum(k, scene.depth))
}

/// The sum `1 + k + .. + k^(terms - 1)`, for `k` from 0 to 1.
///
/// `1 - k^terms` would lose its digits where `k` is close to 1. The difference `k - 1` is exact
/// there, and `expm1` and `log1p` keep small numbers.
fn geometric_sum(k: f64, terms: u32) -> f64 {
    let terms = f64::from(terms);
    if k < 1.0 {
        libm::expm1(terms * libm::log1p(k - 1.0)) / (k - 1.0)
    } else {
        terms
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Emitter, Phong, Shading, Surface};

    /// A perfect mirror that scatters `0.5 (0.25 + 1) + 0.125` itself, before this background.
    fn mirror(background: f64, depth: u32) -> f64 {
        let mut scene = Scene::new(Color::gray(background), Color::gray(0.25), depth);
        scene.add_surface(Surface {
            shading: Shading::Phong(Phong {
                diffuse: Color::gray(0.5),
                specular: Color::gray(0.125),
                exponent: 9.0,
            }),
            reflection: Color::WHITE,
        });
        scene.add_light(Light {
            kind: Emitter::Directional {
                color: Color::WHITE,
                direction: glam::DVec3::NEG_Z,
            },
            casts_shadows: false,
        });
        scene.max_radiance()
    }

    #[test]
    fn each_surface_of_a_path_adds_the_brightest_colour_at_most() {
        assert_eq!(
            [mirror(0.0, 1), mirror(0.0, 2), mirror(0.0, 6)],
            [0.75, 1.5, 4.5]
        );
        assert_eq!([mirror(1.0, 1), mirror(1.0, 4)], [1.0, 4.0]);
    }

    /// Sums of fractions, rounded once. The last has 2^32 - 1 terms of almost 1, by the binomial
    /// series.
    #[test]
    fn geometric_sums_are_those_of_fractions() {
        let (n, e) = (f64::from(u32::MAX), f64::EPSILON / 2.0);
        let [second, third] = [
            n * (n - 1.0) / 2.0 * e,
            n * (n - 1.0) * (n - 2.0) / 6.0 * e * e,
        ];
        for (k, terms, expected) in [
            (0.0, 1, 1.0),
            (0.0, 6, 1.0),
            (0.5, 1, 1.0),
            (0.5, 3, 1.75),
            (0.75, 4, 175.0 / 64.0),
            (1.0, 1, 1.0),
            (1.0, 6, 6.0),
            (0.9, u32::MAX, 10.0),
            (1.0_f64.next_down(), 1, 1.0),
            (1.0 - e, u32::MAX, n - second + third),
        ] {
            let sum = geometric_sum(k, terms);
            let error = (sum - expected).abs();
            assert!(error <= 1e-15 * expected, "{k}, {terms}: {sum}");
        }
    }
}
