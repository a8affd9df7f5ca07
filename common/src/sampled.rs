//! `Sampled`: the number of samples and the error of adaptive sampling.

use std::fmt;
use std::ops::AddAssign;

/// The samples and the error of a picture, or the sum over several parts of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampled {
    /// Number of pixels.
    pub pixels: u64,
    /// Number of samples of all pixels.
    pub samples: u64,
    /// Largest number of samples of a pixel.
    pub most: u32,
    /// The estimated squared error of a channel from 0 to 1, summed over the
    /// pixels.
    pub squared_error: f64,
}

impl Sampled {
    /// The estimated root mean square error of a channel from 0 to 1.
    #[must_use]
    pub fn error(&self) -> f64 {
        (self.squared_error / self.pixels as f64).sqrt()
    }

    /// Whether the error is larger than the requested one.
    #[must_use]
    pub fn misses(&self, asked: Option<f64>) -> bool {
        asked.is_some_and(|asked| self.error() > asked)
    }
}

impl AddAssign for Sampled {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.samples += other.samples;
        self.most = self.most.max(other.most);
        self.squared_error += other.squared_error;
    }
}

impl fmt::Display for Sampled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { samples, most, .. } = self;
        let mean = *samples as f64 / self.pixels as f64;
        let error = self.error();
        write!(
            f,
            "{samples} samples, {mean:.2} a pixel and at most {most}; estimated error {error:.6}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_and_errors_are_per_pixel() {
        let mut sampled = Sampled {
            pixels: 4,
            samples: 10,
            most: 7,
            squared_error: 0.25,
        };
        assert_eq!(sampled.error(), 0.25);
        assert!(sampled.misses(Some(0.2)) && !sampled.misses(Some(0.25)));
        assert!(!sampled.misses(None));
        let said = "10 samples, 2.50 a pixel and at most 7; estimated error 0.250000";
        assert_eq!(sampled.to_string(), said);
        sampled += Sampled {
            pixels: 12,
            samples: 6,
            most: 3,
            squared_error: 3.75,
        };
        let both = Sampled {
            pixels: 16,
            samples: 16,
            most: 7,
            squared_error: 4.0,
        };
        assert_eq!(sampled, both);
    }
}
