//! `Fit`: a straight line through the logarithms of errors, and how good it is.

use std::fmt;
use std::ops::RangeInclusive;

use crate::experiment::{Axis, Curve, Point};

/// The most that errors may stray from a power law, as the root mean square of their
/// residuals in decades: a factor of about the square root of two.
const MOST_SCATTER: f64 = 0.15;

/// The most by which the slope of a power law changes, from end to end or between its halves.
const MOST_BEND: f64 = 0.2;

/// The greatest number of its standard errors that a change of the slope may have and count as noise.
const NOISE: f64 = 2.0;

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
    /// The ends of the line.
    pub ends: [End; 2],
    /// The greatest change of the slope that is no noise; else 0.
    pub bend: f64,
}

/// An end of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// The work or the parameter.
    pub x: f64,
    /// The error.
    pub error: f64,
}

/// How much the slope changes, with the standard error of that.
#[derive(Clone, Copy)]
struct Change {
    slope: f64,
    standard_error: f64,
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
        let (mut yy, mut squared_residuals) = (0.0, 0.0);
        let (mut low, mut high) = (line.mean.x, line.mean.x);
        for p in points {
            let (dy, residual) = (p.y - line.mean.y, line.residual(p));
            yy += dy * dy;
            squared_residuals += residual * residual;
            low = low.min(p.x);
            high = high.max(p.x);
        }
        Some(Self {
            slope: line.slope,
            standard_error: line.standard_error,
            r_squared: if yy > 0.0 {
                1.0 - squared_residuals / yy
            } else {
                1.0
            },
            scatter: (squared_residuals / (count - 2.0)).sqrt(),
            decades: high - low,
            ends: [low, high].map(|x| End {
                x: libm::exp10(x),
                error: libm::exp10(line.mean.y + line.slope * (x - line.mean.x)),
            }),
            bend: bend(points),
        })
    }

    /// Whether the points follow a power law: over a decade or more, they stray from the
    /// line by less than a factor of the square root of two, and it does not bend.
    pub fn is_power_law(&self) -> bool {
        self.decades >= LEAST_DECADES && self.scatter <= MOST_SCATTER && !self.bends()
    }

    /// Whether the slope changes, beyond the noise of the points around the bent curve: the standard
    /// error of the straight line would grow with the bend, and excuse it.
    fn bends(&self) -> bool {
        self.bend.abs() > MOST_BEND
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

/// The greatest change of the slope that is no noise.
fn bend(points: &[LogPoint]) -> f64 {
    let mut greatest: f64 = 0.0;
    for change in [bend_of_parabola(points), bend_between_halves(points)] {
        let Some(change) = change else { continue };
        let is_noise = change.slope.abs() <= NOISE * change.standard_error;
        if !is_noise && change.slope.abs() > greatest.abs() {
            greatest = change.slope;
        }
    }
    greatest
}

/// The slope of the second half of the points, less that of the first. Of an odd number the one in the
/// middle belongs to both.
fn bend_between_halves(points: &[LogPoint]) -> Option<Change> {
    let half = points.len().div_ceil(2);
    let first = line(&points[..half])?;
    let second = line(&points[points.len() - half..])?;
    Some(Change {
        slope: second.slope - first.slope,
        standard_error: libm::hypot(first.standard_error, second.standard_error),
    })
}

/// The slope at the last point, less that at the first, of the parabola of least squares.
fn bend_of_parabola(points: &[LogPoint]) -> Option<Change> {
    let count = points.len() as f64;
    if points.len() < 4 {
        return None;
    }
    let straight = line(points)?;
    let mean_x = points.iter().map(|p| p.x).sum::<f64>() / count;
    // The part of the squares that no straight line explains.
    let squares = points.iter().map(|p| LogPoint {
        x: p.x,
        y: (p.x - mean_x) * (p.x - mean_x),
    });
    let squares: Vec<_> = squares.collect();
    let of_squares = line(&squares)?;
    let (mut qq, mut qy) = (0.0, 0.0);
    for (p, square) in points.iter().zip(&squares) {
        let q = of_squares.residual(square);
        qq += q * q;
        qy += q * straight.residual(p);
    }
    if qq < 1e-9 {
        return None;
    }
    let curvature = qy / qq;
    let mut squared_residuals = 0.0;
    for (p, square) in points.iter().zip(&squares) {
        let residual = straight.residual(p) - curvature * of_squares.residual(square);
        squared_residuals += residual * residual;
    }
    let variance = squared_residuals / (count - 3.0);
    let first = points.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
    let last = points.iter().map(|p| p.x).fold(f64::NEG_INFINITY, f64::max);
    Some(Change {
        slope: 2.0 * curvature * (last - first),
        standard_error: 2.0 * (variance / qq).sqrt() * (last - first),
    })
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
        assert!(kink.bends() && kink.bend > 1.0, "{kink:?}");
        // A parabola from the slope -1/2 to -1, of which a straight line is off by 8 %.
        let parabola: Vec<_> = (0..6)
            .map(|n| f64::from(n) / 2.0)
            .map(|x| (libm::exp10(x), libm::exp10(-0.5 * x - 0.1 * x * x)))
            .collect();
        let parabola = fit(&parabola).unwrap();
        assert!(
            parabola.bends() && (parabola.bend + 0.5).abs() < 1e-9,
            "{parabola:?}"
        );
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
