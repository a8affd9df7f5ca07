//! `Search`: the samples that every pixel needs because of objects that none has met yet.
//!
//! If no sample of `n` in a pixel met an object, the next one might. It would change the
//! pixel by `b/n`, where `b` is the light of the object, and by 1 at most. By the rule of
//! three, at most three pixels of the picture are that far off, with 95 % confidence.

use super::CHANNELS;
use super::check::Estimate;

/// The rule of three: of events of which none was seen, at most three were to be expected,
/// with 95 % confidence.
const UNSEEN: f64 = 3.0;
/// The share of the allowed squared error that objects which no sample met may have.
const HIDDEN: f64 = 0.5;

/// How every pixel is searched.
#[derive(Debug)]
pub struct Search {
    /// The squared error that hidden objects may have.
    hidden: f64,
    /// The most pairs of a pixel.
    most: u32,
    /// Whether each pixel begins with a sample in its middle. Otherwise it begins with half
    /// of its pairs.
    pub middles: bool,
    /// The pairs of samples of a pixel that looks even.
    pub pairs: u32,
    /// The share of pixels that get them. The others keep the sample in the middle.
    pub share: f64,
}

impl Search {
    /// For an allowed squared error, added up over pixels and channels, and at most `most`
    /// pairs of samples of a pixel.
    pub fn new(allowed: f64, most: u32) -> Self {
        let mut search = Self {
            hidden: HIDDEN * allowed,
            most,
            middles: true,
            pairs: 1,
            share: 0.0,
        };
        search.middles = search.samples_for(1.0) <= 3.0;
        search.widen(1.0);
        search
    }

    /// The samples of a pixel with which light up to `brightest` is found.
    fn samples_for(&self, brightest: f64) -> f64 {
        let samples = (CHANNELS * UNSEEN / self.hidden).sqrt();
        if samples > 1.0 {
            samples * brightest
        } else {
            samples
        }
    }

    /// Searches for light up to `brightest`.
    pub fn widen(&mut self, brightest: f64) {
        let samples = self.samples_for(brightest);
        if self.middles && samples <= 1.0 {
            // Each pixel drawn stands for others, and `unseen` grows by their number.
            self.share = self.share.max(samples * samples / UNSEEN);
            return;
        }
        self.share = 1.0;
        if !self.middles || samples > 3.0 {
            let pairs = ((samples / 2.0).ceil() as u32).max(2);
            self.pairs = self.pairs.max(pairs).min(self.most);
        }
    }

    /// Searches more if the check `found` too much where the picture looked even.
    /// Returns whether it does.
    pub fn widen_after(&mut self, found: &Estimate, brightest: f64) -> bool {
        let (share, pairs) = (self.share, self.pairs);
        self.widen(brightest);
        let much = (found.largest() + self.unseen(brightest)) / self.hidden;
        if self.share < 1.0 && much > 1.2 {
            self.share = 1.0;
        } else if self.pairs == pairs && much > 1.2 {
            let more = f64::from(pairs) * much.sqrt().min(2.0);
            self.pairs = (more.ceil() as u32).min(self.most);
        }
        (self.share, self.pairs) != (share, pairs)
    }

    /// The samples of a pixel that looks even, its middle included.
    pub fn samples(&self) -> f64 {
        let middle = f64::from(u8::from(self.middles));
        let pairs = f64::from(2 * self.pairs);
        middle + self.share * pairs
    }

    /// The squared error of objects that no sample met, with 95 % confidence.
    pub fn unseen(&self, brightest: f64) -> f64 {
        if self.share < 1.0 {
            // All middles of three pixels, or of three drawn ones a half, which stand for
            // others: three quarters of 1/share.
            CHANNELS * UNSEEN.max(1.0 / self.share)
        } else {
            let off = (brightest / self.samples()).min(1.0);
            CHANNELS * UNSEEN * off * off
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_objects_have_at_most_half_of_the_allowed_error() {
        for allowed in [1e-6, 0.01, 1.0, 7.0, 30.0, 1e4] {
            for brightest in [1.0, 1.7, 20.0] {
                let mut search = Search::new(allowed, 1 << 20);
                search.widen(brightest);
                let unseen = search.unseen(brightest);
                assert!(unseen <= 0.501 * allowed, "{unseen} of {allowed}");
            }
        }
    }
}
