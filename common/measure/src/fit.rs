//! `Fit`: a straight line through the logarithms of errors, and how good it is.

use std::fmt;
use std::ops::RangeInclusive;

use crate::experiment::{Axis, Curve, Point};

/// The most that errors may stray from a power law, as the root mean square of their
/// residuals in decades: a factor of about the square root of two.
const MOST_SCATTER: f64 = 0.15;

/// The most by which the slopes of both halves of a power law differ.
const MOST_BEND: f64 = 0.2;

/// The least range of a power law, in decades.
const LEAST_DECADES: f64 = 1.0;

/// The least squares line of log error over log work, or over the log of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The slope.
    pub slope: f64,
    /// The standard error of the slope.
    pub standard_error: f64,
    /// The coefficient of determination, R², from 0 to 1. Near 0 for a level line.
    pub r_squared: f64,
    /// The standard deviation of the errors from the line, in decades.
    pub scatter: f64,
    /// The range of work or parameter, in decades.
    pub decades: f64,
    /// The slope of the second half of six or more points, less that of the first; else 0.
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
        let mean_x = points.iter().map(|p| p.x).sum::<f64>() / count;
        let mean_y = points.iter().map(|p| p.y).sum::<f64>() / count;
        // Sums of squares and products of the distances from the means.
        let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
        let (mut low, mut high) = (mean_x, mean_x);
        for p in points {
            let (dx, dy) = (p.x - mean_x, p.y - mean_y);
            xx += dx * dx;
            yy += dy * dy;
            xy += dx * dy;
            low = low.min(p.x);
            high = high.max(p.x);
        }
        if points.len() < 3 || xx < 1e-9 {
            return None;
        }
        let slope = xy / xx;
        let mut squared_residuals = 0.0;
        for p in points {
            let residual = p.y - mean_y - slope * (p.x - mean_x);
            squared_residuals += residual * residual;
        }
        // Two of the points are used up by the two numbers of the line.
        let variance = squared_residuals / (count - 2.0);
        Some(Self {
            slope,
            standard_error: (variance / xx).sqrt(),
            r_squared: if yy > 0.0 {
                1.0 - squared_residuals / yy
            } else {
                1.0
            },
            scatter: variance.sqrt(),
            decades: high - low,
            bend: bend(points),
        })
    }

    /// Whether the points follow a power law: over a decade or more, they stray from the
    /// line by less than a factor of the square root of two, and it does not bend.
    pub fn is_power_law(&self) -> bool {
        self.decades >= LEAST_DECADES && self.scatter <= MOST_SCATTER && !self.bends()
    }

    /// Whether both halves of the points follow other lines, beyond their noise.
    fn bends(&self) -> bool {
        self.bend.abs() > MOST_BEND.max(6.0 * self.standard_error)
    }

    /// The slope with its standard error.
    pub fn slope_in_words(&self) -> String {
        // Not "-0.000".
        let slope = libm::round(self.slope * 1e3) / 1e3 + 0.0;
        format!("slope {slope:.3} ± {:.3}", self.standard_error)
    }
}

/// The slope with its standard error, or the reason why there is none.
impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.decades < LEAST_DECADES {
            f.write_str("no power law: less than a decade")
        } else if self.scatter > MOST_SCATTER {
            let factor = libm::pow(10.0, self.scatter).min(99.0);
            write!(f, "no power law: a factor of {factor:.1} off a line")
        } else if self.bends() {
            let (slope, bend) = (self.slope_in_words(), self.bend);
            write!(f, "no power law: {slope}, but it changes by {bend:.2}")
        } else {
            let r_squared = self.r_squared;
            write!(f, "{}, R² {r_squared:.4}", self.slope_in_words())
        }
    }
}

/// The slope of the second half of the points, less that of the first; 0 if a half is too short.
fn bend(points: &[LogPoint]) -> f64 {
    let (first, second) = points.split_at(points.len() / 2);
    match (Fit::through(first), Fit::through(second)) {
        (Some(first), Some(second)) => second.slope - first.slope,
        _ => 0.0,
    }
}

/// The work at which a method reaches an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The counted work.
    pub work: f64,
    /// Whether the work is greater than that of all measurements, by the line through them.
    pub is_extrapolated: bool,
}

impl Curve<'_> {
    /// The line of the points in the range in which theory expects the slope; of all
    /// points where it expects none. Errors of 0 have no logarithm and take no part.
    pub fn fit(&self, axis: Axis) -> Option<Fit> {
        match &self.slope {
            Some(slope) => self.fit_between(axis, &slope.between),
            None => self.fit_between(axis, &(0.0..=f64::INFINITY)),
        }
    }

    fn fit_between(&self, axis: Axis, between: &RangeInclusive<f64>) -> Option<Fit> {
        let mut points = Vec::new();
        for point in &self.points {
            let (x, error) = (point.on(axis), point.errors.rms);
            let has_logarithms = x > 0.0 && error > 0.0 && error.is_finite();
            if has_logarithms && between.contains(&x) {
                points.push(LogPoint {
                    x: libm::log10(x),
                    y: libm::log10(error),
                });
            }
        }
        Fit::through(&points)
    }

    /// The work that brings the error down to `target`. Between two points it is
    /// interpolated on the straight line through both. Beyond the last point it is
    /// extrapolated if the points before it follow a falling power law.
    pub fn work_to_reach(&self, target: f64) -> Option<Reached> {
        let errors = self.points.iter().map(|point| point.errors.rms);
        let Some(at) = errors.into_iter().position(|error| error <= target) else {
            return self.extrapolated(target);
        };
        let work = match at.checked_sub(1) {
            None => self.points[0].work,
            Some(before) => interpolated(&self.points[before], &self.points[at], target),
        };
        Some(Reached {
            work,
            is_extrapolated: false,
        })
    }

    /// The work on the line through the last points, of those within a factor of 300.
    fn extrapolated(&self, target: f64) -> Option<Reached> {
        let last = self.points.last()?;
        let near_the_end = last.work / 300.0..=last.work;
        let fit = self.fit_between(Axis::Work, &near_the_end)?;
        let falls = fit.is_power_law() && fit.slope < -2.0 * fit.standard_error;
        let work = last.work * libm::pow(target / last.errors.rms, 1.0 / fit.slope);
        (falls && work.is_finite()).then_some(Reached {
            work,
            is_extrapolated: true,
        })
    }
}

/// The work at an error between those of two points, on the line through their logarithms.
fn interpolated(a: &Point, b: &Point, target: f64) -> f64 {
    let [error_a, error_b] = [a, b].map(|point| point.errors.rms);
    let slope = libm::log(error_b / error_a) / libm::log(b.work / a.work);
    let work = a.work * libm::pow(target / error_a, 1.0 / slope);
    if work.is_finite() { work } else { b.work }
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
        assert!((exact.slope + 0.5).abs() < 1e-12 && exact.standard_error < 1e-12);
        assert_eq!(exact.to_string(), "slope -0.500 ± 0.000, R² 1.0000");
        let with_zero = [&powers[..], &[(256.0, 0.0)]].concat();
        assert_eq!(fit(&with_zero), Some(exact), "0 has no logarithm");
    }

    /// Logarithms (0, 0), (1, 0.1), (2, 0) and (3, 0.1): the slope is 0.02, the residuals
    /// are -0.02, 0.06, -0.06 and 0.02, their squares add up to 0.008, and those of the
    /// errors to 0.01.
    #[test]
    fn the_quality_of_a_fit_is_that_of_the_textbook() {
        let up = libm::pow(10.0, 0.1);
        let fit = fit(&[(1.0, 1.0), (10.0, up), (100.0, 1.0), (1000.0, up)]).unwrap();
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(fit.slope, 0.02), "{fit:?}");
        assert!(near(fit.scatter, 0.004_f64.sqrt()), "{fit:?}");
        assert!(near(fit.standard_error, 0.0008_f64.sqrt()), "{fit:?}");
        assert!(near(fit.r_squared, 0.2), "{fit:?}");
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
        assert!(kink.bends() && (kink.bend - 1.0).abs() < 1e-12, "{kink:?}");
        let short = fit(&[(1.0, 1.0), (2.0, 0.5), (4.0, 0.25)]).unwrap();
        assert_eq!(short.to_string(), "no power law: less than a decade");
        assert_eq!(fit(&[(1.0, 1.0), (1000.0, 0.5)]), None);
        assert_eq!(fit(&[(1.0, 1.0), (1.0, 0.5), (1.0, 0.2)]), None);
    }

    #[test]
    fn the_work_to_reach_an_error_is_read_off_the_curve() {
        let measured = |work| Some((work, false));
        let extrapolated = |work| Some((work, true));
        let halving: &[_] = &[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)];
        let steps: &[_] = &[(1.0, 1.0), (4.0, 0.25), (400.0, 0.0025)];
        let level: &[_] = &[(1.0, 0.5), (9.0, 0.5), (81.0, 0.5)];
        let bent: &[_] = &[(1.0, 0.8), (10.0, 0.8), (100.0, 0.2)];
        for (points, target, expected) in [
            (halving, 1.0, measured(1.0)),
            (halving, 0.4, measured(4.0)),
            (halving, 0.1, extrapolated(64.0)),
            (steps, 0.025, measured(40.0)),
            (level, 0.1, None),
            (bent, 0.1, None),
        ] {
            let found = curve(points).work_to_reach(target);
            let found =
                found.map(|found| (libm::round(found.work * 1e6) / 1e6, found.is_extrapolated));
            assert_eq!(found, expected);
        }
    }
}
