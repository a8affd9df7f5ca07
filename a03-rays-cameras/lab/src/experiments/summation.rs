//! The rounding error of the sum over the samples of a pixel.

use a02_lab::exact::sum_with_error;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Point, Unit};

/// The sum that keeps the rounding errors in a second number (Neumaier,
/// Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, 1974).
pub fn neumaier(terms: impl Iterator<Item = f64>) -> f64 {
    let (sum, lost) = terms.fold((0.0, 0.0), |(sum, lost), term| {
        let (next, error) = sum_with_error(sum, term);
        (next, lost + error)
    });
    sum + lost
}

/// The mean of `n` terms that are all `x`.
type Mean = fn(f64, u32) -> f64;

/// The channels of equal samples. The mean equals each sample.
fn channels() -> impl Iterator<Item = f64> {
    (1..=16).map(|i| f64::from(i) / 17.0)
}

pub fn experiment() -> Experiment<'static> {
    Experiment::new("summation")
        .asking("What does a sum of many samples lose?")
        .over(Axis::Parameter, "terms", "additions")
        .with_error("rms error of the mean of equal terms")
        .with_unit(Unit::Other("terms from 1/17 to 16/17"))
        .with_exact("against the term")
        .with_curves(|effort| {
            let curve = |method, epsilon, mean: Mean| {
                let point = |power| {
                    let n = 10_u32.pow(power);
                    let error = |x| Deviation::new(mean(x, n) - x, x, 1.0).of_epsilon(epsilon);
                    let run = move || channels().map(|x| mean(x, n)).sum::<f64>();
                    Point::new(n.into(), 16.0 * f64::from(n), channels().map(error), run)
                };
                Curve::new(method, (0..=effort.choose(6, 7) as u32).map(point))
            };
            vec![
                curve("plain sum", f64::EPSILON, |x, n| {
                    (0..n).fold(0.0, |sum, _| sum + x) / f64::from(n)
                })
                .with_slope(1.0, (100.0, 1e6)),
                curve("Neumaier's sum", f64::EPSILON, |x, n| {
                    neumaier((0..n).map(|_| x)) / f64::from(n)
                })
                .with_bound(f64::EPSILON, 1.0..=1e9),
                // The sum stays constant once a term is less than half a unit in its last place.
                curve("plain sum in 32 bits", f32::EPSILON.into(), |x, n| {
                    f64::from((0..n).fold(0.0_f32, |sum, _| sum + x as f32) / n as f32)
                }),
            ]
        })
}
