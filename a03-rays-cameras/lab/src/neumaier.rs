//! A sum that keeps its rounding errors.

use a02_lab::exact::sum_with_error;

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
