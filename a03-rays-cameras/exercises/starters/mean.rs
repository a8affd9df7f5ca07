//! A mean that does not drift.

/// The mean of the numbers, as if their sum was rounded once; 0 if there is
/// none.
pub fn mean(numbers: &[f64]) -> f64 {
    let sum: f64 = numbers.iter().sum();
    testing::missing("what the additions lose", sum / numbers.len() as f64)
}
