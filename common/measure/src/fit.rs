//! `Fit`: a straight line through the logarithms of errors, and how good it is.

use std::fmt;

use crate::experiment::{Axis, Curve, Interval};
use crate::rounded_interval::RoundedInterval;
use crate::t_distribution;

/// The most that errors may stray from a power law, as the root mean square of their
/// residuals in decades: a factor of about the square root of two.
const MAX_SCATTER: f64 = 0.15;

/// The most by which the slope of a power law changes between its halves.
const MAX_BEND: f64 = 0.2;

/// The least range of a power law, in decades.
const MIN_DECADES: f64 = 1.0;

/// The least squares line of log error over log work, or over the log of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The slope.
    pub slope: f64,
    /// Half of the slope's interval of 95 %.
    pub half_width: f64,
    /// The standard deviation of the errors from the line, in decades.
    pub scatter: f64,
    /// The range of work or parameter, in decades.
    pub decades: f64,
    /// The change of the slope between the halves, if that is no noise; else 0.
    pub bend: f64,
}

/// The logarithms of a point, to base 10.
#[derive(Clone, Copy)]
struct LogPoint {
    /// Of the work or the parameter.
    x: f64,
    /// Of the error.
    y: f64,
}

impl Fit {
    /// The line through three or more points. None if there are fewer, or if all lie
    /// one above the other. (N. R. Draper and H. Smith, Applied Regression Analysis,
    /// 1998, chapter 1)
    fn through(points: &[LogPoint]) -> Option<Self> {
        let count = points.len() as f64;
        let line = line(points)?;
        let mut squared_residuals = 0.0;
        let (mut low, mut high) = (line.mean.x, line.mean.x);
        for p in points {
            let residual = line.residual(p);
            squared_residuals += residual * residual;
            low = low.min(p.x);
            high = high.max(p.x);
        }
        Some(Self {
            slope: line.slope,
            half_width: t_distribution::factor(points.len() - 2) * line.standard_error,
            scatter: (squared_residuals / (count - 2.0)).sqrt(),
            decades: high - low,
            bend: bend(points),
        })
    }

    /// Whether the points follow a power law: over a decade or more, they stray from the
    /// line by less than a factor of the square root of two, and it does not bend.
    pub fn is_power_law(&self) -> bool {
        self.decades >= MIN_DECADES && self.scatter <= MAX_SCATTER && !self.bends()
    }

    /// Whether the slope changes, beyond the noise of the points around the bent curve: the standard
    /// error of the straight line would grow with the bend, and excuse it.
    fn bends(&self) -> bool {
        self.bend.abs() > MAX_BEND
    }

    /// The slope with its interval.
    fn slope_in_words(&self) -> String {
        format!(
            "slope {}",
            RoundedInterval::around(self.slope, self.half_width)
        )
    }

    /// The interval of the slope.
    pub(crate) fn interval(&self) -> Interval {
        Interval {
            low: self.slope - self.half_width,
            high: self.slope + self.half_width,
        }
    }
}

/// The slope with its interval, or the reason why there is none.
impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.decades < MIN_DECADES {
            f.write_str("no power law: less than a decade")
        } else if self.scatter > MAX_SCATTER {
            let factor = libm::pow(10.0, self.scatter).min(99.0);
            write!(f, "no power law: a factor of {factor:.1} off a line")
        } else if self.bends() {
            let (slope, bend) = (self.slope_in_words(), self.bend);
            write!(f, "no power law: {slope}, but it changes by {bend:.2}")
        } else {
            f.write_str(&self.slope_in_words())
        }
    }
}

/// The slope of the second half of the points, less that of the first, if that is no noise; else 0. Of
/// an odd number the point in the middle belongs to both.
fn bend(points: &[LogPoint]) -> f64 {
    let half = points.len().div_ceil(2);
    let halves = [&points[..half], &points[points.len() - half..]];
    let [Some(first), Some(second)] = halves.map(line) else {
        return 0.0;
    };
    let change = second.slope - first.slope;
    let standard_error = libm::hypot(first.standard_error, second.standard_error);
    // Two of the points of each half are used up by its line.
    if change.abs() <= t_distribution::factor(2 * half - 4) * standard_error {
        0.0
    } else {
        change
    }
}

/// A straight line of least squares.
struct Line {
    mean: LogPoint,
    slope: f64,
    standard_error: f64,
}

impl Line {
    fn residual(&self, p: &LogPoint) -> f64 {
        p.y - self.mean.y - self.slope * (p.x - self.mean.x)
    }
}

/// The line through three or more points. None if there are fewer, or if all lie one above the other.
fn line(points: &[LogPoint]) -> Option<Line> {
    let count = points.len() as f64;
    let mean = LogPoint {
        x: points.iter().map(|p| p.x).sum::<f64>() / count,
        y: points.iter().map(|p| p.y).sum::<f64>() / count,
    };
    // Sums of squares and products of the distances from the means.
    let (mut xx, mut xy) = (0.0, 0.0);
    for p in points {
        xx += (p.x - mean.x) * (p.x - mean.x);
        xy += (p.x - mean.x) * (p.y - mean.y);
    }
    if points.len() < 3 || xx < 1e-9 {
        return None;
    }
    let mut line = Line {
        mean,
        slope: xy / xx,
        standard_error: 0.0,
    };
    let squares = points.iter().map(|p| line.residual(p) * line.residual(p));
    // Two of the points are used up by the two numbers of the line.
    let variance = squares.sum::<f64>() / (count - 2.0);
    line.standard_error = (variance / xx).sqrt();
    Some(line)
}

impl Curve<'_> {
    /// The line of the points in the range in which theory expects the slope; of all
    /// points where it expects none. Errors of 0 have no logarithm and take no part.
    pub fn fit(&self, axis: Axis) -> Option<Fit> {
        let has_theory = |x: f64| {
            let slope = self.slope.as_ref();
            slope.is_none_or(|slope| slope.between.contains(&x))
        };
        let mut points = Vec::new();
        for point in &self.points {
            let (x, error) = (point.on(axis), point.errors.rms);
            let has_logarithms = x > 0.0 && error > 0.0 && error.is_finite();
            if has_logarithms && has_theory(x) {
                points.push(LogPoint {
                    x: libm::log10(x),
                    y: libm::log10(error),
                });
            }
        }
        Fit::through(&points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example::curve;

    fn fit(points: &[(f64, f64)]) -> Option<Fit> {
        curve(points).fit(Axis::Work)
    }

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let powers = [1.0, 4.0, 16.0, 64.0].map(|n: f64| (n, 0.3 / n.sqrt()));
        let exact = fit(&powers).unwrap();
        assert!((exact.slope + 0.5).abs() < 1e-12 && exact.half_width < 1e-12);
        assert_eq!(exact.to_string(), "slope -0.500 ± 0.001");
        let with_zero = [&powers[..], &[(256.0, 0.0)]].concat();
        assert_eq!(fit(&with_zero), Some(exact), "0 has no logarithm");
    }

    /// Logarithms (0, 0), (1, 0.1), (2, 0) and (3, 0.1): the slope is 0.02, the residuals
    /// are -0.02, 0.06, -0.06 and 0.02, and their squares add up to 0.008.
    #[test]
    fn the_quality_of_a_fit_is_that_of_the_textbook() {
        let up = libm::pow(10.0, 0.1);
        let fit = fit(&[(1.0, 1.0), (10.0, up), (100.0, 1.0), (1000.0, up)]).unwrap();
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(fit.slope, 0.02), "{fit:?}");
        assert!(near(fit.scatter, 0.004_f64.sqrt()), "{fit:?}");
        // Student's t of two degrees of freedom.
        assert!(near(fit.half_width, 4.303 * 0.0008_f64.sqrt()), "{fit:?}");
    }

    #[test]
    fn bent_short_and_few_points_have_no_power_law() {
        let bent = fit(&[(10.0, 1e-1), (100.0, 1e-1), (1000.0, 1e-4)]).unwrap();
        assert!(!bent.is_power_law() && (bent.slope + 1.5).abs() < 1e-12);
        assert!(bent.to_string().starts_with("no power law: a factor"));
        // The error grows with the work, and from 100 on with its square.
        let kink = [0.0, 1.0, 2.0, 4.0, 6.0, 8.0];
        let kink: Vec<_> = (0..6)
            .map(|n| (libm::exp10(n.into()), libm::exp10(kink[n as usize])))
            .collect();
        let kink = fit(&kink).unwrap();
        assert!(kink.bends() && (kink.bend - 1.0).abs() < 1e-9, "{kink:?}");
        // A parabola from the slope -1/2 to -1, of which a straight line is off by 8 %.
        let parabola: Vec<_> = (0..6)
            .map(|n| f64::from(n) / 2.0)
            .map(|x| (libm::exp10(x), libm::exp10(-0.5 * x - 0.1 * x * x)))
            .collect();
        let parabola = fit(&parabola).unwrap();
        // Its slopes in the middles of both halves are -0.6 and -0.9.
        assert!(
            parabola.bends() && (parabola.bend + 0.3).abs() < 1e-9,
            "{parabola:?}"
        );
        let short = fit(&[(1.0, 1.0), (2.0, 0.5), (4.0, 0.25)]).unwrap();
        assert_eq!(short.to_string(), "no power law: less than a decade");
        assert_eq!(fit(&[(1.0, 1.0), (1000.0, 0.5)]), None);
        assert_eq!(fit(&[(1.0, 1.0), (1.0, 0.5), (1.0, 0.2)]), None);
    }
}
