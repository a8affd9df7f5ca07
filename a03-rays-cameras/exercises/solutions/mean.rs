//! A mean that does not drift.

/// The mean of the numbers, as if their sum was rounded once; 0 if there is
/// none.
pub fn mean(numbers: &[f64]) -> f64 {
    // Neumaier (1974): the rounding errors of the additions have a sum of their own.
    let (mut sum, mut lost) = (0.0_f64, 0.0);
    for &x in numbers {
        let next = sum + x;
        let (large, small) = if sum.abs() >= x.abs() {
            (sum, x)
        } else {
            (x, sum)
        };
        lost += (large - next) + small;
        sum = next;
    }
    (sum + lost) / numbers.len().max(1) as f64
}
