//! The rounding error of the sum over the samples of a pixel.

use a02_lab::exact::sum_with_error;
use measure::Effort;
use measure::experiment::{
    Axis, Curve, Deviation, ErrorBound, Errors, Experiment, Point, Slope, Times, Unit,
};

/// The sum that keeps the rounding errors in a second number (Neumaier,
/// Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, 1974).
pub fn neumaier(terms: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut lost) = (0.0, 0.0);
    for term in terms {
        let next = sum_with_error(sum, term);
        sum = next.sum;
        lost += next.error;
    }
    sum + lost
}

/// The mean of `n` terms that are all `x`.
type Mean = fn(x: f64, n: u32) -> f64;

fn plain_mean(x: f64, n: u32) -> f64 {
    let mut sum = 0.0;
    for _ in 0..n {
        sum += x;
    }
    sum / f64::from(n)
}

fn neumaier_mean(x: f64, n: u32) -> f64 {
    neumaier((0..n).map(|_| x)) / f64::from(n)
}

/// It stays constant once a term is less than half a unit in the last place of the sum.
fn plain_mean_in_32_bits(x: f64, n: u32) -> f64 {
    let mut sum = 0.0;
    for _ in 0..n {
        sum += x as f32;
    }
    f64::from(sum / n as f32)
}

/// The channels of equal samples. The mean equals each sample.
fn channels() -> impl Iterator<Item = f64> {
    (1..=16).map(|i| f64::from(i) / 17.0)
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "What does a sum of many samples lose?",
        parameter: "terms",
        work: "additions",
        against: Axis::Parameter,
        error: "rms error of the mean of equal terms",
        unit: Unit::Other("terms from 1/17 to 16/17"),
        exact: "against the term",
        curves: Box::new(curves),
        ..Experiment::new("summation")
    }
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let most_terms = effort.choose(6, 7) as u32;
    let curve = |method, epsilon, mean: Mean| {
        let points = (0..=most_terms).map(|power| point(10_u32.pow(power), epsilon, mean));
        Curve::new(method, points)
    };
    vec![
        Curve {
            slope: Some(Slope {
                value: 1.0,
                between: 100.0..=1e6,
            }),
            ..curve("plain sum", f64::EPSILON, plain_mean)
        },
        Curve {
            bound: Some(ErrorBound {
                error: f64::EPSILON,
                between: 1.0..=1e9,
            }),
            ..curve("Neumaier's sum", f64::EPSILON, neumaier_mean)
        },
        curve(
            "plain sum in 32 bits",
            f32::EPSILON.into(),
            plain_mean_in_32_bits,
        ),
    ]
}

/// The measurement of a method for `n` terms, in a precision of this epsilon.
fn point(n: u32, epsilon: f64, mean: Mean) -> Point<'static> {
    let mut errors = Vec::new();
    for x in channels() {
        errors.push(Deviation::new(mean(x, n) - x, x, 1.0).of_epsilon(epsilon));
    }
    Point {
        parameter: n.into(),
        work: 16.0 * f64::from(n),
        errors: Errors::of(errors),
        times: Times::of(move || channels().map(|x| mean(x, n)).sum::<f64>()),
    }
}
