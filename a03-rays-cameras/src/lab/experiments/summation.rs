//! The rounding error of the sum over the samples of a pixel.

use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

/// The sum that keeps the rounding errors in a second number (Neumaier,
/// Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, 1974).
pub fn neumaier(terms: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut lost) = (0.0_f64, 0.0);
    for x in terms {
        let next = sum + x;
        lost += if sum.abs() >= x.abs() {
            (sum - next) + x
        } else {
            (x - next) + sum
        };
        sum = next;
    }
    sum + lost
}

/// The mean of `n` terms that are all `x`.
type Mean = fn(f64, u32) -> f64;

fn plain(x: f64, n: u32) -> f64 {
    (0..n).fold(0.0, |sum, _| sum + x) / f64::from(n)
}

fn compensated(x: f64, n: u32) -> f64 {
    neumaier((0..n).map(|_| x)) / f64::from(n)
}

/// Single precision: the sum stays constant once a term is less than half a unit
/// in its last place.
fn single(x: f64, n: u32) -> f64 {
    f64::from((0..n).fold(0.0_f32, |sum, _| sum + x as f32) / n as f32)
}

/// The channels of equal samples. The mean equals each sample.
fn channels() -> impl Iterator<Item = f64> {
    (1..=16).map(|i| f64::from(i) / 17.0)
}

pub fn experiment() -> Experiment<'static> {
    let curves = |effort: Effort| {
        let curve = |method, mean: Mean| {
            let point = |power| {
                let n = 10_u32.pow(power);
                let errors = channels().map(|x| mean(x, n) - x);
                let run = move || channels().map(|x| mean(x, n)).sum::<f64>();
                Point::new(n.into(), 16.0 * f64::from(n), errors, run)
            };
            Curve::new(method, (0..=effort.choose(6, 7) as u32).map(point))
        };
        vec![
            curve("plain sum", plain).with_slope(1.0, (100.0, 1e6)),
            curve("Neumaier's sum", compensated)
                .with_bound(f64::EPSILON, 1.0..=1e9)
                .with_remark(COMPENSATED),
            curve("plain sum in 32 bits", single),
        ]
    };
    Experiment {
        name: "summation",
        about: "What does a sum of many samples lose?",
        knob: "terms",
        work: "additions",
        error: "rms error of the mean of equal terms",
        unit: Unit::Other("terms from 1/17 to 16/17"),
        exact: "against the term",
        seeds: &[],
        against: Axis::Work,
        curves: Box::new(curves),
    }
}

const COMPENSATED: &str =
    "not in the renderer: a pixel's few thousand samples lose less than 1e-11 in the plain sum";
