//! `Contrasts`: how much the light of each pixel can change, as far as that is known before the first
//! sample; and the samples that follow from it.

use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use super::CHANNELS;
use super::pilot::Pilot;

/// The contrast of each pixel; empty if nothing is known.
pub struct Contrasts(pub Vec<f32>);

impl Contrasts {
    /// The largest contrast; infinite if one is unknown.
    pub fn largest(&self) -> f64 {
        let contrasts = self.0.par_iter().copied();
        contrasts
            .reduce_with(f32::max)
            .unwrap_or(f32::INFINITY)
            .into()
    }

    /// The pairs of samples that each pixel needs to find light up to `brightest`; empty if all
    /// need those of the pilot.
    pub fn least_pairs(&self, pilot: &Pilot, brightest: f64) -> Vec<u32> {
        let contrasts = self.0.par_iter();
        let pairs = contrasts.map(|contrast| pilot.pairs_for(f64::from(*contrast), brightest));
        pairs.collect()
    }

    /// Limits the variances of samples, added up over the channels: a number that changes by no
    /// more than `c` has at most the variance `c²/4`. (Popoviciu, Sur les équations algébriques ayant
    /// toutes leurs racines réelles, 1935.)
    pub fn limit(&self, variances: &mut [f32]) {
        let pixels = variances.par_iter_mut().zip(&self.0);
        pixels.for_each(|(variance, contrast)| {
            let largest = CHANNELS as f32 / 4.0 * contrast * contrast;
            *variance = variance.min(largest);
        });
    }
}
