//! What a report says: its table, its slopes beside those of theory, and what they mean.

use std::fmt::Write;

use common::{Median, text};
use judge::pictures::Axis;
use measure::RoundedInterval;
use measure::experiment::{self, Curve, Errors, HALF_GREY_LEVEL, Interval, Times};
use measure::fit::Fit;

use super::{Point, Report, SIDE};
use crate::sheet::history::Earlier;

impl Report<'_> {
    /// The table, the slopes, and what they mean.
    pub fn words(&self, earlier: Option<&Earlier>) -> String {
        let theory = self.precision.theory;
        let (samples, error) = if self.counts_tests() {
            ("balls", "tests of a ray")
        } else {
            ("samples", "error of a pixel")
        };
        let mut words = format!("{samples:>9}{error:>18}{:>9}", "theory");
        if self.points[0].blocks.is_some() {
            let _ = write!(words, "{:>20}", "mean of 16 pixels");
        }
        let _ = writeln!(words, "{:>18}", "seconds");
        for point in &self.points {
            let (samples, error) = (point.samples, in_words(&point.errors));
            let theory = text::rounded(point.theory, 3);
            let _ = write!(words, "{samples:>9}{error:>18}{theory:>9}");
            if let Some(blocks) = &point.blocks {
                let _ = write!(words, "{:>20}", in_words(blocks));
            }
            let Median { low, value, high } = point.seconds;
            let seconds = RoundedInterval::within(value, low, high).to_string();
            let _ = writeln!(words, "{seconds:>18}");
        }
        let (name, formula) = (&theory.name, &theory.formula);
        let _ = writeln!(
            words,
            "± is half of the interval of 95 %. Theory, {name}: {formula}"
        );
        for sentence in self.sentences() {
            words.extend([&*sentence, "\n"]);
        }
        words.extend(earlier.and_then(|earlier| self.since(earlier)));
        words.extend(["Not seen here: ", &theory.unseen, "\n"]);
        words
    }

    /// What the errors say about the program.
    fn sentences(&self) -> Vec<String> {
        let fact = self.precision.fact;
        let is_linear = self.precision.axis == Axis::Linear;
        let parameter = |point: &Point| {
            let samples = f64::from(point.samples);
            // A straight line over the samples is one over the logarithm of this.
            if is_linear {
                libm::exp(samples)
            } else {
                samples
            }
        };
        let Some(slope) = self.fit(|point| [parameter(point), point.errors.rms]) else {
            return Vec::new();
        };
        let over = if self.counts_tests() {
            "balls"
        } else {
            "samples"
        };
        let theory = text::number(fact.value);
        let mut sentences = vec![format!(
            "slope over {over} {}; theory: {theory}",
            sure(slope)
        )];
        let seconds = |point: &Point| point.seconds.value;
        if self.counts_tests() {
            if let Some(of_time) = self.fit(|point| [parameter(point), seconds(point)]) {
                let [tests, time] = [slope, of_time].map(|fit| libm::pow(10.0, fit.slope));
                sentences.push(format!(
                    "Ten times as many balls take {tests:.1} times the tests, and {time:.1} times the time, in which \
                     the tree is built, too."
                ));
            }
        } else {
            let of_program = self.fit(|point| [seconds(point), point.errors.rms]);
            let of_theory = self.fit(|point| [seconds(point), point.theory]);
            let takes_time = match &*self.points {
                [first, .., last] => seconds(last) > 2.0 * seconds(first),
                _ => false,
            };
            sentences.push(match (of_program, of_theory) {
                (Some(of_program), Some(of_theory)) if takes_time => format!(
                    "slope over seconds {}; theory, with your seconds: {:.2}",
                    sure(of_program),
                    of_theory.slope
                ),
                _ => "All take about the same time: most of it starts the program, and writes the picture."
                    .to_owned(),
            });
        }
        let off = slope.slope - fact.value;
        let how = if off.abs() <= slope.half_width.max(fact.within) {
            "as theory says"
        } else if off > 0.0 {
            "more slowly than theory says"
        } else {
            "faster than theory says"
        };
        sentences.push(match slope.slope {
            _ if self.counts_tests() => {
                format!("The tests grow {}.", how.replace("more slowly", "faster"))
            }
            _ if is_linear => format!(
                "The error falls {how}: each further ray leaves {:.2} of it.",
                libm::exp(slope.slope)
            ),
            ..-0.1 => format!(
                "The error falls {how}: half of it takes {:.1} times the samples.",
                libm::pow(2.0, -1.0 / slope.slope)
            ),
            _ => "The error does not fall: more samples bring nothing.".to_owned(),
        });
        sentences.extend(self.shared(&slope));
        sentences
    }

    /// What pixels have in common, if it is more than chance and the rounding to bytes. The means of blocks of independent
    /// pixels have a quarter of their error; a common error stays.
    fn shared(&self, slope: &Fit) -> Option<String> {
        let is_shared = |point: &Point, factor: f64| {
            let by_chance = factor * point.errors.interval.high / SIDE as f64;
            let most = libm::hypot(by_chance, HALF_GREY_LEVEL);
            let blocks = point.blocks.as_ref();
            blocks.is_some_and(|blocks| blocks.interval.low > most)
        };
        let [first, .., last] = &*self.points else {
            return None;
        };
        // With few samples noise is greater than most shifts.
        if is_shared(first, 2.0) && slope.slope < self.precision.fact.value / 2.0 {
            return Some(
                "Neighbouring pixels have the same error: has each pixel random numbers of its own?"
                    .to_owned(),
            );
        }
        if !is_shared(last, 1.0) {
            return None;
        }
        let of_block = last.blocks.as_ref().map_or(0.0, |blocks| blocks.rms);
        let pixels = (SIDE * SIDE) as f64;
        let squared =
            (pixels * of_block * of_block - last.errors.rms * last.errors.rms) / (pixels - 1.0);
        Some(format!(
            "An error of {} stays, however many samples: the mean is wrong, as by a shift or a clamp.",
            text::rounded(squared.max(0.0).sqrt(), 2)
        ))
    }

    /// What has changed since an earlier report.
    fn since(&self, earlier: &Earlier) -> Option<String> {
        let last = self.points.last()?;
        let before = earlier.iter().find(|point| point.samples == last.samples)?;
        let [error, seconds] = [
            last.errors.rms / before.error,
            last.seconds.value / before.seconds,
        ];
        let noun = if self.counts_tests() {
            "tests"
        } else {
            "error"
        };
        Some(format!(
            "Since your last report: {error:.2} times the {noun}, and {seconds:.2} times the seconds, in the last row.\n"
        ))
    }

    /// The line through the logarithms of pairs of numbers.
    fn fit(&self, pair: impl Fn(&Point) -> [f64; 2]) -> Option<Fit> {
        let point = |point: &Point| {
            let [x, y] = pair(point);
            experiment::Point {
                parameter: x,
                work: x,
                errors: Errors::of([y]),
                times: Times::of(|| ()),
            }
        };
        Curve::new("", self.points.iter().map(point)).fit(experiment::Axis::Work)
    }
}

fn sure(fit: Fit) -> RoundedInterval {
    RoundedInterval::around(fit.slope, fit.half_width)
}

fn in_words(errors: &Errors) -> String {
    let Interval { low, high } = errors.interval;
    RoundedInterval::within(errors.rms, low, high).to_string()
}
