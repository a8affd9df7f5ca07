//! A mean that does not drift.

/// The mean of the numbers, as if their sum was rounded once; 0 if there is none.
pub fn mean(numbers: &[f64]) -> f64 {
    missing!("what the additions lose", numbers.iter().sum::<f64>(), {
        // Neumaier (1974): the rounding errors of the additions have a sum of their own.
        let (mut sum, mut lost) = (0.0_f64, 0.0);
        for &x in numbers {
            let next = sum + x;
            let is_larger = sum.abs() >= x.abs();
            let (large, small) = if is_larger { (sum, x) } else { (x, sum) };
            lost += (large - next) + small;
            sum = next;
        }
        (sum + lost) / numbers.len().max(1) as f64
    })
}

testing::examples! {
    assert!(mean(&[]) == 0.0, "the mean of nothing");
    assert!(mean(&[1.0, 2.0, 6.0]) == 3.0, "the mean of 1, 2 and 6");
    assert!(mean(&[0.1; 1000]) == 0.1, "a thousand times 0.1");
    assert!(mean(&[1.0, 1e100, 1.0, -1e100]) == 0.5, "1 beside 1e100");
}
