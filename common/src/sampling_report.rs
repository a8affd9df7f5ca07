//! `SamplingReport`: the samples and the error of a picture by adaptive sampling.

use std::fmt;

/// The samples and the error of a picture. Errors are for channels from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SamplingReport {
    /// Number of pixels.
    pub pixels: u64,
    /// Number of samples of all pixels, with those that only checked the error.
    pub samples: u64,
    /// Largest number of samples that a pixel has taken, the one in its middle included.
    pub most: u32,
    /// The squared error that the checks estimate, summed over the pixels.
    pub squared_error: f64,
    /// The variance of `squared_error`.
    pub variance: f64,
    /// The largest squared error by objects that no sample met, with 95 % confidence, summed
    /// over the pixels.
    pub unseen: f64,
    /// The brightest channel that these objects are assumed to have.
    pub brightest: f64,
    /// Upper bound of their brightest channel, which follows from the scene: no ray brings back more
    /// light; infinite if it is unknown.
    pub max_radiance: f64,
}

/// The standard deviations between the mean of a normal distribution and the number that 95 % of
/// it lie below.
const ONE_SIDED: f64 = 1.645;

impl SamplingReport {
    /// Upper bound of the root mean square error of a channel, with 95 % confidence.
    #[must_use]
    pub fn max_error(&self) -> f64 {
        let doubt = ONE_SIDED * self.variance.sqrt();
        let sum = self.squared_error + doubt + self.unseen;
        (sum.max(0.0) / self.pixels as f64).sqrt()
    }

    /// Whether the error may be larger than the requested one.
    #[must_use]
    pub fn misses(&self, asked: Option<f64>) -> bool {
        asked.is_some_and(|asked| self.max_error() > asked)
    }

    /// The largest of the three parts of the squared error, in words, and its percentage.
    #[must_use]
    pub fn largest_part(&self) -> String {
        let doubt = ONE_SIDED * self.variance.sqrt();
        let parts = [
            (self.unseen, "is for things that no sample may have met"),
            (
                self.squared_error,
                "is what new samples differ from those before",
            ),
            (
                doubt,
                "is the doubt about what new samples differ from those before",
            ),
        ];
        let (mut largest, mut sum) = (parts[0], 0.0);
        for part in parts {
            sum += part.0;
            if part.0 > largest.0 {
                largest = part;
            }
        }
        let (part, words) = largest;
        format!("{:.0} % of its square {words}", 100.0 * part / sum)
    }

    /// Whether an object that no sample met may be brighter than assumed.
    #[must_use]
    pub fn is_conditional(&self) -> bool {
        self.max_radiance > self.brightest
    }
}

impl fmt::Display for SamplingReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { samples, most, .. } = self;
        let mean = *samples as f64 / self.pixels as f64;
        let largest = self.max_error();
        write!(
            f,
            "{samples} samples, {mean:.2} a pixel and at most {most}; root mean square error at \
             most {largest:.6} (95 %)"
        )?;
        if self.is_conditional() {
            let Self {
                brightest,
                max_radiance,
                ..
            } = self;
            write!(f, ", if no light is brighter than {brightest:.2}: ")?;
            if max_radiance.is_finite() {
                write!(f, "no promise, because it may be {max_radiance:.2}")?;
            } else {
                write!(f, "no promise, because nobody knows how bright it may be")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The squared errors are 1 + 1.645 x 1/4 + 1.58875, of 4 pixels.
    const SAMPLED: SamplingReport = SamplingReport {
        pixels: 4,
        samples: 10,
        most: 7,
        squared_error: 1.0,
        variance: 0.0625,
        unseen: 1.588_75,
        brightest: 1.5,
        max_radiance: 1.5,
    };

    #[test]
    fn means_and_errors_are_per_pixel() {
        assert!(SAMPLED.misses(Some(0.865)) && !SAMPLED.misses(Some(0.867)));
        assert!(!SAMPLED.misses(None));
        assert_eq!(
            SAMPLED.largest_part(),
            "53 % of its square is for things that no sample may have met"
        );
        let text = "10 samples, 2.50 a pixel and at most 7; root mean square error at most \
                    0.866025 (95 %)";
        assert_eq!(SAMPLED.to_string(), text);
        let max_radiance = f64::INFINITY;
        let unknown = SamplingReport {
            max_radiance,
            ..SAMPLED
        };
        let unpromised = format!("{text}, if no light is brighter than 1.50: no promise, because");
        assert_eq!(
            unknown.to_string(),
            format!("{unpromised} nobody knows how bright it may be")
        );
        let brighter = SamplingReport {
            max_radiance: 40.0,
            ..SAMPLED
        };
        assert_eq!(
            brighter.to_string(),
            format!("{unpromised} it may be 40.00")
        );
    }
}
