//! `Pixel`: the samples of a pixel so far.

use common::Color;

/// The pairs of samples of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Pixel {
    /// The sum over all samples.
    sum: Color,
    /// The squared distance of the sum of each pair from the mean of these sums, added up
    /// over pairs and channels.
    scatter: f32,
    pairs: u32,
}

impl Pixel {
    /// No samples.
    pub const NONE: Self = Self {
        sum: Color::BLACK,
        scatter: 0.0,
        pairs: 0,
    };

    /// Adds the light of a pair of samples.
    pub fn add(&mut self, [a, b]: [Color; 2]) {
        self.merge(&Self {
            sum: a + b,
            scatter: 0.0,
            pairs: 1,
        });
    }

    /// Adds other samples of this pixel. (The scatter as in Chan, Golub, `LeVeque`: Algorithms
    /// for Computing the Sample Variance, 1983.)
    pub fn merge(&mut self, other: &Self) {
        if self.pairs > 0 {
            let [here, there] = [f64::from(self.pairs), f64::from(other.pairs)];
            let apart = other.sum * (1.0 / there) - self.sum * (1.0 / here);
            let between = dot(apart, apart) * (here * there / (here + there));
            self.scatter += between as f32;
        }
        self.sum += other.sum;
        self.scatter += other.scatter;
        self.pairs += other.pairs;
    }

    /// The number of pairs.
    pub const fn pairs(&self) -> u32 {
        self.pairs
    }

    /// The mean light of the samples.
    pub fn mean(&self) -> Color {
        self.sum.map(|sum| sum / f64::from(2 * self.pairs))
    }

    /// The mean as a screen shows it, from 0 to 1.
    pub fn shown(&self) -> Color {
        self.mean().map(|channel| channel.clamp(0.0, 1.0))
    }

    /// The variance of a sample, added up over the channels, from the differences between
    /// pairs: within a pair, light that changes evenly differs and does no harm. None if there
    /// is only one pair.
    pub fn variance(&self) -> Option<f32> {
        (self.pairs > 1).then(|| 0.5 * self.scatter / (self.pairs - 1) as f32)
    }
}

/// The sum over the channels of the products of two colours.
pub fn dot(a: Color, b: Color) -> f64 {
    a.r * b.r + a.g * b.g + a.b * b.b
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAIRS: [[f64; 2]; 4] = [[1.0, 2.0], [0.5, 0.5], [0.0, 4.0], [3.0, 1.0]];

    fn pixel(pairs: &[[f64; 2]]) -> Pixel {
        let mut pixel = Pixel::NONE;
        for [a, b] in pairs {
            pixel.add([Color::new(*a, 0.0, 2.0), Color::new(*b, 0.0, 2.0)]);
        }
        pixel
    }

    /// The sums 3, 1, 4 and 4 have the mean 3 and the squared distances 0, 4, 1 and 1.
    #[test]
    fn mean_and_variance_are_those_of_the_pairs() {
        assert_eq!(pixel(&PAIRS[..1]).variance(), None);
        let all = pixel(&PAIRS);
        assert_eq!(all.mean(), Color::new(1.5, 0.0, 2.0));
        assert_eq!(all.shown(), Color::new(1.0, 0.0, 1.0));
        assert_eq!(all.pairs(), 4);
        assert!((all.variance().unwrap() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn merged_samples_are_those_of_one_pixel() {
        let (mut first, second) = (pixel(&PAIRS[..1]), pixel(&PAIRS[1..]));
        first.merge(&second);
        let all = pixel(&PAIRS);
        assert_eq!((first.mean(), first.pairs()), (all.mean(), 4));
        assert!((first.variance().unwrap() - 1.0).abs() < 1e-6);
    }

    /// The first place of a pair and its mirror image see light that changes evenly at equal
    /// distances above and below its mean.
    #[test]
    fn light_that_changes_evenly_has_no_variance() {
        let even = [[0.2, 0.6], [0.1, 0.7], [0.35, 0.45]];
        assert!(pixel(&even).variance().unwrap() < 1e-12);
    }
}
