//! `Fit`: a straight line through the logarithms of errors, and how good it is.

use std::fmt;

use crate::experiment::{Axis, Curve};

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

impl Fit {
    /// The line through three or more points. None if there are fewer, or if all lie
    /// one above the other. (N. R. Draper and H. Smith, Applied Regression Analysis,
    /// 1998, chapter 1)
    fn through(points: &[(f64, f64)]) -> Option<Self> {
        let log = |(x, y): &(f64, f64)| (libm::log10(*x), libm::log10(*y));
        let logs: Vec<_> = points.iter().map(log).collect();
        let count = logs.len() as f64;
        let sum = |f: &dyn Fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>();
        let (x, y) = (sum(&|p| p.0) / count, sum(&|p| p.1) / count);
        let along = sum(&|p| (p.0 - x) * (p.0 - x));
        let up = sum(&|p| (p.1 - y) * (p.1 - y));
        if logs.len() < 3 || along < 1e-9 {
            return None;
        }
        let slope = sum(&|p| (p.0 - x) * (p.1 - y)) / along;
        let residual = |p: &(f64, f64)| p.1 - y - slope * (p.0 - x);
        let squares = sum(&|p| residual(p) * residual(p));
        let variance = squares / (count - 2.0);
        let (low, high) = (logs.iter().map(|p| p.0)).fold((x, x), |(a, b), x| (a.min(x), b.max(x)));
        Some(Self {
            slope,
            standard_error: (variance / along).sqrt(),
            r_squared: if up > 0.0 { 1.0 - squares / up } else { 1.0 },
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

fn bend(points: &[(f64, f64)]) -> f64 {
    let (first, second) = points.split_at(points.len() / 2);
    let halves = [first, second].map(|half| Some(Fit::through(half)?.slope));
    halves[1].zip(halves[0]).map_or(0.0, |(b, a)| b - a)
}

impl Curve<'_> {
    /// The line of the points in the range in which theory expects the slope; of all
    /// points where it expects none. Errors of 0 have no logarithm and take no part.
    pub fn fit(&self, axis: Axis) -> Option<Fit> {
        let everywhere = (0.0, f64::INFINITY);
        let (from, to) = self.slope.map_or(everywhere, |(_, range)| range);
        self.fit_between(axis, from, to)
    }

    fn fit_between(&self, axis: Axis, from: f64, to: f64) -> Option<Fit> {
        let points = self.points.iter().map(|point| (point.on(axis), point.rms));
        let inside = |(x, error): &(f64, f64)| {
            *x > 0.0 && (from..=to).contains(x) && *error > 0.0 && error.is_finite()
        };
        Fit::through(&points.filter(inside).collect::<Vec<_>>())
    }

    /// The work that brings the error down to `target`. Between two points it is
    /// interpolated on the straight line through both. Beyond the last point it is
    /// extrapolated if the points before it follow a falling power law, and the flag is
    /// true.
    pub fn work_to_reach(&self, target: f64) -> Option<(f64, bool)> {
        let reached = self.points.iter().position(|point| point.rms <= target);
        match reached {
            Some(0) => Some((self.points[0].work, false)),
            Some(at) => {
                let (a, b) = (&self.points[at - 1], &self.points[at]);
                let slope = libm::log(b.rms / a.rms) / libm::log(b.work / a.work);
                let work = a.work * libm::pow(target / a.rms, 1.0 / slope);
                Some((if work.is_finite() { work } else { b.work }, false))
            }
            None => {
                let last = self.points.last()?;
                let fit = self.fit_between(Axis::Work, last.work / 300.0, last.work)?;
                let falls = fit.is_power_law() && fit.slope < -2.0 * fit.standard_error;
                let work = last.work * libm::pow(target / last.rms, 1.0 / fit.slope);
                (falls && work.is_finite()).then_some((work, true))
            }
        }
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
        let halving: &[_] = &[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)];
        let steps: &[_] = &[(1.0, 1.0), (4.0, 0.25), (400.0, 0.0025)];
        let level: &[_] = &[(1.0, 0.5), (9.0, 0.5), (81.0, 0.5)];
        let bent: &[_] = &[(1.0, 0.8), (10.0, 0.8), (100.0, 0.2)];
        for (points, target, expected) in [
            (halving, 1.0, Some((1.0, false))),
            (halving, 0.4, Some((4.0, false))),
            (halving, 0.1, Some((64.0, true))),
            (steps, 0.025, Some((40.0, false))),
            (level, 0.1, None),
            (bent, 0.1, None),
        ] {
            let found = curve(points).work_to_reach(target);
            let found = found.map(|(work, beyond)| (libm::round(work * 1e6) / 1e6, beyond));
            assert_eq!(found, expected);
        }
    }
}
