//! The slope of the straight line through the logarithms of errors over samples.

/// What the logarithm of the error is drawn over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The logarithm of the samples: a power of them is a straight line.
    #[default]
    Logarithm,
    /// The samples themselves, such as a depth of which each step leaves the same part of the error.
    Linear,
}

/// The error of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub samples: u32,
    pub error: f64,
}

/// The slope of the least squares line through three or more points. (N. R. Draper and H. Smith, Applied Regression
/// Analysis, 1998, chapter 1)
pub fn fitted_slope(points: &[Point], axis: Axis) -> Result<f64, String> {
    let mut logs = Vec::new();
    for Point { samples, error } in points {
        if *error == 0.0 {
            return Err(format!(
                "with {samples} samples the picture is exact already: does the program use --samples?"
            ));
        }
        let samples = f64::from(*samples);
        let x = match axis {
            Axis::Logarithm => libm::log(samples),
            Axis::Linear => samples,
        };
        logs.push((x, libm::log(*error)));
    }
    let count = logs.len() as f64;
    let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
    let (mut xx, mut xy) = (0.0, 0.0);
    for (x, y) in &logs {
        xx += (x - mean_x) * (x - mean_x);
        xy += (x - mean_x) * (y - mean_y);
    }
    Ok(xy / xx)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(samples: [u32; 3], errors: [f64; 3], axis: Axis) -> Result<f64, String> {
        let point = |(samples, error)| Point { samples, error };
        let points: Vec<_> = samples.into_iter().zip(errors).map(point).collect();
        fitted_slope(&points, axis)
    }

    /// In logarithms to the base 2 the points are (0, 0), (1, 1) and (2, 1): the slope is 1/2.
    #[test]
    fn the_slope_is_that_of_least_squares() {
        let found = of([1, 2, 4], [1.0, 2.0, 2.0], Axis::Logarithm).unwrap();
        assert!((found - 0.5).abs() < 1e-12, "{found}");
        assert_eq!(of([1, 2, 4], [1.0, 0.5, 0.25], Axis::Logarithm), Ok(-1.0));
        let steps = of([1, 2, 3], [1.0, 0.5, 0.25], Axis::Linear);
        assert_eq!(steps, Ok(-std::f64::consts::LN_2));
        let none = of([1, 2, 4], [1.0, 0.0, 1.0], Axis::Linear).unwrap_err();
        assert!(none.contains("2 samples"), "{none}");
    }
}
