//! `Pixel`: the samples of a pixel so far.

use common::Color;

/// The samples of a pixel: one in its middle, or pairs.
#[derive(Clone, Copy, Debug)]
pub struct Pixel {
    /// The sum over all samples.
    sum: Color,
    /// The squared distance of the sum of each pair from the mean of these sums, added up
    /// over pairs and channels.
    scatter: f32,
    /// The squared error that the last check estimated, added up over the channels.
    squared_error: f32,
    pairs: u32,
    /// The number of pairs after the last check; the largest number where only background is seen.
    checked_pairs: u32,
}

impl Pixel {
    /// No samples.
    pub const NONE: Self = Self {
        sum: Color::BLACK,
        scatter: 0.0,
        squared_error: 0.0,
        pairs: 0,
        checked_pairs: 0,
    };

    /// The light of a sample in the middle.
    pub const fn of_middle(light: Color) -> Self {
        Self {
            sum: light,
            ..Self::NONE
        }
    }

    /// The light of a pixel of which no sample differs: it takes no more.
    pub const fn of_background(light: Color) -> Self {
        Self {
            checked_pairs: u32::MAX,
            ..Self::of_middle(light)
        }
    }

    /// Whether no sample differs.
    pub const fn is_background(&self) -> bool {
        self.checked_pairs == u32::MAX
    }

    /// The light of a pair of samples.
    pub fn of_pair([a, b]: [Color; 2]) -> Self {
        Self {
            sum: a + b,
            pairs: 1,
            ..Self::NONE
        }
    }

    /// Adds other pairs of this pixel, which replace a sample in the middle: its place is not drawn
    /// at random, and would bias the mean. (The scatter is that of Chan, Golub, `LeVeque`:
    /// Algorithms for Computing the Sample Variance, 1983.)
    pub fn merge(&mut self, other: &Self) {
        if self.pairs == 0 {
            self.sum = other.sum;
        } else {
            let [here, there] = [f64::from(self.pairs), f64::from(other.pairs)];
            let difference = other.sum * (1.0 / there) - self.sum * (1.0 / here);
            let between = dot(difference, difference) * (here * there / (here + there));
            self.scatter += between as f32;
            self.sum += other.sum;
        }
        self.scatter += other.scatter;
        self.pairs += other.pairs;
    }

    /// Adds pairs that no decision has seen, and estimates the squared error by them.
    ///
    /// Let `a` and `1 - a` be the fractions of old and new samples. If their means are independent,
    /// the squared error of the mean of all is `a (1 - a)` times the squared difference of both,
    /// on average. The samples here keep away from each other, so it is less.
    pub fn check(&mut self, new: &Self) {
        let difference = self.clamped_mean() - new.clamped_mean();
        let a = f64::from(self.pairs) / f64::from(self.pairs + new.pairs);
        let factor = if a > 0.0 { a * (1.0 - a) } else { 1.0 };
        self.merge(new);
        self.checked_pairs = self.pairs;
        self.squared_error = (factor * dot(difference, difference)) as f32;
    }

    /// The squared error that the last check estimated, added up over the channels.
    pub fn squared_error(&self) -> f64 {
        // A pixel that is NaN has no error; another message counts these.
        if self.squared_error.is_finite() {
            self.squared_error.into()
        } else {
            0.0
        }
    }

    /// The number of pairs after the last check.
    pub const fn checked_pairs(&self) -> u32 {
        self.checked_pairs
    }

    /// The number of pairs.
    pub const fn pairs(&self) -> u32 {
        self.pairs
    }

    /// The mean light of the samples.
    pub fn mean(&self) -> Color {
        if self.pairs == 0 {
            return self.sum;
        }
        self.sum / f64::from(2 * self.pairs)
    }

    /// The mean as a screen shows it, from 0 to 1.
    pub fn clamped_mean(&self) -> Color {
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

    /// The sums 3, 1, 4 and 4 have the mean 3 and the squared distances 0, 4, 1 and 1.
    #[test]
    fn mean_and_variance_are_those_of_the_pairs() {
        let mut all = Pixel::NONE;
        for pair in [[1.0, 2.0], [0.5, 0.5], [0.0, 4.0], [3.0, 1.0]] {
            let pair = pair.map(|light| Color::new(light, 0.0, 2.0));
            all.merge(&Pixel::of_pair(pair));
        }
        assert_eq!(all.mean(), Color::new(1.5, 0.0, 2.0));
        assert_eq!(all.clamped_mean(), Color::new(1.0, 0.0, 1.0));
        assert_eq!(all.pairs(), 4);
        assert!((all.variance().unwrap() - 1.0).abs() < 1e-6);
    }

    /// The means 1/4 and 3/4 differ by a half. With a half of the samples each, the squared error
    /// is a quarter of the squared difference; with 3/4 and 1/4, it is 3/16 of it.
    #[test]
    fn a_check_estimates_the_error_of_all_samples_together() {
        let [low, high] = [0.25, 0.75].map(|light| [Color::new(light, 0.0, 0.0); 2]);
        for (pairs, error) in [(1, 1.0 / 16.0), (3, 3.0 / 64.0)] {
            let mut pixel = Pixel::NONE;
            (0..pairs).for_each(|_| pixel.merge(&Pixel::of_pair(low)));
            pixel.check(&Pixel::of_pair(high));
            assert_eq!((pixel.squared_error(), pixel.pairs()), (error, pairs + 1));
        }
    }
}
