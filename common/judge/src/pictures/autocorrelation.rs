//! The autocorrelation of a picture of noise: whether pixels repeat others.

use crate::pictures::values::{Region, Values};

impl Values<'_> {
    /// The greatest correlation, of either sign, between pixels and those at the same distance from each: up to one
    /// column beside them, and up to three quarters of the region below. None if all pixels are the same.
    pub fn autocorrelation(&self, region: Region) -> Option<f64> {
        if self.greatest(region) == self.least(region) {
            return None;
        }
        let mean = self.mean(region);
        let deviations: Vec<f64> = region.pixels().map(|at| self.at(at) - mean).collect();
        let squares = deviations.iter().map(|deviation| deviation * deviation);
        let variance = squares.sum::<f64>() / deviations.len() as f64;
        let rows: Vec<&[f64]> = deviations.chunks(region.width as usize).collect();
        let mut greatest = 0.0_f64;
        for below in 0..=rows.len() * 3 / 4 {
            let pairs = rows.iter().zip(&rows[below..]);
            let covariance = |from: usize, to: usize| {
                let (mut sum, mut count) = (0.0, 0.0);
                for (row, other) in pairs.clone() {
                    for (a, b) in row[from..].iter().zip(&other[to..]) {
                        sum += a * b;
                        count += 1.0;
                    }
                }
                sum / count
            };
            let mut covariances = vec![covariance(0, 1)];
            if below > 0 {
                covariances.extend([covariance(0, 0), covariance(1, 0)]);
            }
            for covariance in covariances {
                greatest = greatest.max((covariance / variance).abs());
            }
        }
        Some(greatest)
    }
}
