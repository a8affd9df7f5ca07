//! `Sampled`: the samples and the error of a picture by adaptive sampling.

use std::fmt;

/// The samples and the error of a picture. Errors are for channels from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampled {
    /// Number of pixels.
    pub pixels: u64,
    /// Number of samples of all pixels, with those that only checked the error.
    pub samples: u64,
    /// Largest number of samples of a pixel.
    pub most: u32,
    /// How often a pixel was audited: compared with new samples.
    pub audited: u64,
    /// The squared error that the audits estimate, summed over the pixels.
    pub squared_error: f64,
    /// The variance of `squared_error`.
    pub variance: f64,
    /// The largest squared error by objects that no sample met, with 95 % confidence, summed
    /// over the pixels.
    pub unseen: f64,
}

impl Sampled {
    /// The least and the largest root mean square error of a channel: it lies between them
    /// with 95 % confidence. A normal distribution lies within two standard deviations.
    #[must_use]
    pub fn error(&self) -> [f64; 2] {
        let doubt = 2.0 * self.variance.sqrt();
        let sum = self.squared_error;
        let squares = [sum - doubt, sum.max(0.0) + doubt + self.unseen];
        squares.map(|sum| (sum.max(0.0) / self.pixels as f64).sqrt())
    }

    /// Whether the error may be larger than the requested one.
    #[must_use]
    pub fn misses(&self, asked: Option<f64>) -> bool {
        asked.is_some_and(|asked| self.error()[1] > asked)
    }
}

impl fmt::Display for Sampled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            samples,
            most,
            audited,
            ..
        } = self;
        let mean = *samples as f64 / self.pixels as f64;
        let [least, largest] = self.error();
        write!(
            f,
            "{samples} samples, {mean:.2} a pixel and at most {most}; root mean square error \
             between {least:.6} and {largest:.6} (95 %), {audited} pixels audited"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The squared errors are 1 - 2 x 1/4 and 1 + 2 x 1/4 + 3/4, of 4 pixels.
    const SAMPLED: Sampled = Sampled {
        pixels: 4,
        samples: 10,
        most: 7,
        audited: 3,
        squared_error: 1.0,
        variance: 0.0625,
        unseen: 0.75,
    };

    #[test]
    fn means_and_errors_are_per_pixel() {
        assert!(SAMPLED.misses(Some(0.74)) && !SAMPLED.misses(Some(0.75)));
        assert!(!SAMPLED.misses(None));
        let text = "10 samples, 2.50 a pixel and at most 7; root mean square error between \
                    0.353553 and 0.750000 (95 %), 3 pixels audited";
        assert_eq!(SAMPLED.to_string(), text);
    }
}
