//! `FittedSlope`: the slope of the straight line through the logarithms of errors over samples, and its interval.

/// The quantile of Student's t that leaves 2.5 % above it, by the number of points less two.
const T_QUANTILES: [f64; 8] = [
    12.706_204_7,
    4.302_652_7,
    3.182_446_3,
    2.776_445_1,
    2.570_581_8,
    2.446_911_9,
    2.364_624_3,
    2.306_004_1,
];

/// What the logarithm of the error is drawn over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The logarithm of the samples: a power of them is a straight line.
    #[default]
    Logarithm,
    /// The samples themselves, such as a depth of which each step leaves the same part of the error.
    Linear,
}

/// The error of the pictures of a scene, by their numbers of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub samples: u32,
    /// The time of the run.
    pub seconds: f64,
    pub error: f64,
}

/// The slope of log error over samples or their logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedSlope {
    pub slope: f64,
    /// The distance from the slope to either end of the interval that holds the true one with 95 %, if the
    /// errors follow the line.
    pub within: f64,
}

impl FittedSlope {
    /// The least squares line through three or more points. (N. R. Draper and H. Smith, Applied Regression
    /// Analysis, 1998, chapter 1)
    pub fn through(points: &[Point], axis: Axis) -> Result<Self, String> {
        let mut logs = Vec::new();
        for point in points {
            if point.error == 0.0 {
                let samples = point.samples;
                return Err(format!(
                    "with {samples} samples the picture is exact already: does the program use --samples?"
                ));
            }
            let x = match axis {
                Axis::Logarithm => libm::log(point.samples.into()),
                Axis::Linear => point.samples.into(),
            };
            logs.push((x, libm::log(point.error)));
        }
        let count = logs.len() as f64;
        let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
        let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
        let (mut xx, mut xy) = (0.0, 0.0);
        for (x, y) in &logs {
            xx += (x - mean_x) * (x - mean_x);
            xy += (x - mean_x) * (y - mean_y);
        }
        let slope = xy / xx;
        let mut squared_residuals = 0.0;
        for (x, y) in &logs {
            let residual = (y - mean_y) - slope * (x - mean_x);
            squared_residuals += residual * residual;
        }
        let standard_error = (squared_residuals / (count - 2.0) / xx).sqrt();
        // For more points the quantile is a little smaller.
        let quantile = T_QUANTILES[(logs.len() - 3).min(T_QUANTILES.len() - 1)];
        Ok(Self {
            slope,
            within: quantile * standard_error,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(samples: [u32; 3], errors: [f64; 3], axis: Axis) -> Result<FittedSlope, String> {
        let point = |(samples, error)| Point {
            samples,
            seconds: 0.0,
            error,
        };
        let points: Vec<_> = samples.into_iter().zip(errors).map(point).collect();
        FittedSlope::through(&points, axis)
    }

    /// In logarithms to the base 2 the points are (0, 0), (1, 1) and (2, 1): the slope is 1/2, the residuals are
    /// -1/6, 1/3 and -1/6, and so its standard error is √(1/12).
    #[test]
    fn the_interval_is_that_of_student() {
        let found = slope([1, 2, 4], [1.0, 2.0, 2.0], Axis::Logarithm).unwrap();
        assert!((found.slope - 0.5).abs() < 1e-12, "{found:?}");
        let within = 12.706_204_7 / 12.0_f64.sqrt();
        assert!((found.within - within).abs() < 1e-12, "{found:?}");
        let power = slope([1, 2, 4], [1.0, 0.5, 0.25], Axis::Logarithm).unwrap();
        assert_eq!((power.slope, power.within), (-1.0, 0.0));
        let steps = slope([1, 2, 3], [1.0, 0.5, 0.25], Axis::Linear).unwrap();
        assert_eq!((steps.slope, steps.within), (-std::f64::consts::LN_2, 0.0));
        let none = slope([1, 2, 4], [1.0, 0.0, 1.0], Axis::Linear).unwrap_err();
        assert!(none.contains("2 samples"), "{none}");
    }
}
