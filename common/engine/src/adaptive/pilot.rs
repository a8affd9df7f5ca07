//! `Pilot`: the samples that every pixel needs to find objects that lie between all samples so far.
//!
//! If no sample of `n` in a pixel hit an object, the next one might. It would change the
//! pixel by `b/n`, where `b` is the light of the object, and by 1 at most. By the rule of
//! three, at most three pixels of the picture have such an error, with 95 % confidence.

use super::CHANNELS;
use super::check::Estimate;

/// The rule of three: of events of which none was seen, at most three were to be expected,
/// with 95 % confidence.
const RULE_OF_THREE: f64 = 3.0;
/// Samples of a pixel that are always allowed: two pairs, which show its variance.
const FEWEST: u32 = 4;
/// Squared error of objects between all samples, relative to the allowed one.
pub const UNSEEN: f64 = 0.6;

/// The pilot samples of a picture.
#[derive(Debug)]
pub struct Pilot {
    /// Upper bound of the squared error of objects between all samples.
    max_unseen: f64,
    /// The number of pixels in which there may be objects.
    pub searched: f64,
    /// The most pairs of a pixel.
    pub max_pairs: u32,
    /// Whether each pixel begins with a sample in its middle. Otherwise it begins with half
    /// of its pairs.
    pub middles: bool,
    /// The pairs of samples of a pixel that is not refined.
    pub pairs: u32,
    /// The fraction of pixels that get them, chosen at random. The others keep the sample in the
    /// middle.
    pub fraction: f64,
}

impl Pilot {
    /// For an allowed squared error, added up over pixels and channels, and at most `max_samples`
    /// samples of a pixel, but four if it is less.
    pub fn new(allowed: f64, max_samples: u32) -> Self {
        let max_samples = max_samples.max(FEWEST);
        let mut pilot = Self {
            max_unseen: UNSEEN * allowed,
            searched: f64::INFINITY,
            max_pairs: max_samples / 2,
            middles: true,
            pairs: 1,
            fraction: 0.0,
        };
        pilot.middles = pilot.samples_for(1.0) <= 3.0 && max_samples > FEWEST;
        if pilot.middles {
            pilot.max_pairs = (max_samples - 1) / 2;
        }
        pilot.widen(1.0);
        pilot
    }

    /// The samples of a pixel that find light up to `brightest`.
    fn samples_for(&self, brightest: f64) -> f64 {
        let samples = (CHANNELS * RULE_OF_THREE / self.max_unseen).sqrt();
        if samples > 1.0 {
            samples * brightest
        } else {
            samples
        }
    }

    /// Increases the samples to those for light up to `brightest`.
    pub fn widen(&mut self, brightest: f64) {
        let samples = self.samples_for(brightest);
        if self.middles && samples <= 1.0 {
            // Each chosen pixel stands for others, and `unseen` grows by their number.
            self.fraction = self.fraction.max(samples * samples / RULE_OF_THREE);
            return;
        }
        self.fraction = 1.0;
        if !self.middles || samples > 3.0 {
            let pairs = ((samples / 2.0).ceil() as u32).max(2);
            self.pairs = self.pairs.max(pairs).min(self.max_pairs);
        }
    }

    /// Increases the samples for this allowed squared error, and more if the checks `found` too
    /// large an error in pixels with pilot samples only. Returns whether it does.
    pub fn widen_for(&mut self, allowed: f64, found: &Estimate, brightest: f64) -> bool {
        self.max_unseen = UNSEEN * allowed;
        let (fraction, pairs) = (self.fraction, self.pairs);
        self.widen(brightest);
        let ratio = (found.largest() + self.unseen(brightest)) / self.max_unseen;
        if self.fraction < 1.0 && ratio > 1.2 {
            self.fraction = 1.0;
        } else if self.pairs == pairs && ratio > 1.2 {
            let more = f64::from(pairs) * ratio.sqrt().min(2.0);
            self.pairs = (more.ceil() as u32).min(self.max_pairs);
        }
        (self.fraction, self.pairs) != (fraction, pairs)
    }

    /// The mean number of pilot samples of a pixel, its middle included.
    pub fn samples(&self) -> f64 {
        let middle = f64::from(u8::from(self.middles));
        middle + self.fraction * f64::from(2 * self.pairs)
    }

    /// The squared error of objects between all samples, with 95 % confidence.
    pub fn unseen(&self, brightest: f64) -> f64 {
        let (pixels, error) = if self.fraction < 1.0 {
            // All middles of three pixels, or half of three chosen ones, which stand for
            // others: three quarters of 1/fraction.
            (RULE_OF_THREE.max(1.0 / self.fraction), brightest)
        } else {
            (RULE_OF_THREE, brightest / self.samples())
        };
        let error = error.min(1.0);
        let pixels = pixels.min(self.searched);
        CHANNELS * pixels * error * error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unseen_objects_have_at_most_their_share_of_the_allowed_error() {
        for allowed in [1e-6, 0.01, 1.0, 7.0, 30.0, 1e4] {
            for brightest in [1.0, 1.7, 20.0] {
                let mut pilot = Pilot::new(allowed, 1 << 21);
                pilot.widen(brightest);
                let unseen = pilot.unseen(brightest);
                assert!(unseen <= 0.601 * allowed, "{unseen} of {allowed}");
            }
        }
    }
}
