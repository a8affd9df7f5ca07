//! `TimeToError`: the time that a method takes to an error that somebody wants.

use common::Median;

use crate::experiment::{Curve, Point};
use crate::front::EQUAL_TIMES;

/// The work and the time with which a method reaches an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeToError {
    /// The number of the curve.
    pub curve: usize,
    /// The parameter, such as the samples per pixel.
    pub parameter: f64,
    /// The time in seconds. Its upper end is infinite if no measured point is below the error for sure.
    pub time: Median,
}

/// A point as it is measured, or one end of its intervals in both directions.
#[derive(Clone, Copy)]
struct Place {
    parameter: f64,
    error: f64,
    seconds: f64,
}

/// The methods that reach an error, the soonest first; and how many of them, from the first one on, may be
/// the soonest: the intervals of the others begin beyond the first one's end by more than what counts as equal for a
/// [front](crate::report::Measured::front).
///
/// `next` says which parameter, from a number on, the method of a name can take.
pub fn soonest(
    curves: &[Curve],
    error: f64,
    next: impl Fn(&str, f64) -> f64,
) -> (Vec<TimeToError>, usize) {
    let mut times = Vec::new();
    for (curve, of) in curves.iter().enumerate() {
        let next = |parameter| next(of.method, parameter);
        times.extend(time_to_error(curve, &of.points, error, next));
    }
    times.sort_by(|a, b| a.time.value.total_cmp(&b.time.value));
    let first = times.first().copied();
    times.sort_by_key(|one| first.is_some_and(|first| is_slower(one, &first)));
    let may_be = |one: &&TimeToError| first.is_some_and(|first| !is_slower(one, &first));
    let ties = times.iter().take_while(may_be).count();
    (times, ties)
}

fn is_slower(one: &TimeToError, first: &TimeToError) -> bool {
    EQUAL_TIMES * first.time.high < one.time.low
}

/// Between two measured points the error falls as a power of the work, and of the time. The interval
/// comes from the better ends of both intervals of each point, and from the worse ones.
fn time_to_error(
    curve: usize,
    points: &[Point],
    error: f64,
    next: impl Fn(f64) -> f64,
) -> Option<TimeToError> {
    let along = |place: fn(&Point) -> Place| first_below(points.iter().map(place), error, &next);
    let middle = along(|point| Place {
        parameter: point.parameter,
        error: point.errors.rms,
        seconds: point.times.seconds.value,
    })?;
    let best = along(|point| Place {
        parameter: point.parameter,
        error: point.errors.interval.low,
        seconds: point.times.seconds.low,
    });
    let worst = along(|point| Place {
        parameter: point.parameter,
        error: point.errors.interval.high,
        seconds: point.times.seconds.high,
    });
    Some(TimeToError {
        curve,
        parameter: middle.parameter,
        time: Median {
            // The ends of a few rounds may lie on one side of the middle.
            low: best.map_or(middle.seconds, |best| best.seconds.min(middle.seconds)),
            value: middle.seconds,
            high: worst.map_or(f64::INFINITY, |worst| worst.seconds.max(middle.seconds)),
        },
    })
}

/// Where the error is first reached: at the first point, or between two of them at the next parameter that the
/// method can take. Points without a time are left out.
fn first_below(
    places: impl Iterator<Item = Place>,
    error: f64,
    next: impl Fn(f64) -> f64,
) -> Option<Place> {
    let mut before: Option<Place> = None;
    for place in places.filter(|place| place.seconds.is_finite()) {
        if place.error > error {
            before = Some(place);
            continue;
        }
        let Some(before) = before else {
            return Some(place);
        };
        // How far the way from the point before is, in logarithms.
        let mut way = if place.error > 0.0 {
            libm::log(before.error / error) / libm::log(before.error / place.error)
        } else {
            1.0
        };
        let between = |from: f64, to: f64, way| from * libm::pow(to / from, way);
        let wanted = between(before.parameter, place.parameter, way);
        // The measured point is one that the method can take.
        let parameter = next(wanted).min(place.parameter);
        if parameter > wanted {
            way = libm::log(parameter / before.parameter)
                / libm::log(place.parameter / before.parameter);
        }
        return Some(Place {
            parameter,
            error: between(before.error, place.error, way),
            seconds: between(before.seconds, place.seconds, way),
        });
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    /// Of a method that takes every number.
    fn any(_: &str, number: f64) -> f64 {
        number
    }

    /// A curve whose times are a thousandth of its work, give or take a fraction.
    fn timed(points: &[(f64, f64)], noise: f64) -> Curve<'static> {
        let mut curve = example::curve(points);
        for point in &mut curve.points {
            let value = point.work / 1000.0;
            point.times.seconds = Median {
                low: value * (1.0 - noise),
                value,
                high: value * (1.0 + noise),
            };
        }
        curve
    }

    /// One over the square root reaches 1/8 with 64 steps, between 16 and 256; one over the work
    /// with 8, and a hundredth over it with less than 1.
    #[test]
    fn the_work_for_an_error_is_that_of_the_power_law() {
        let root = timed(&[(1.0, 1.0), (16.0, 0.25), (256.0, 0.0625)], 0.0);
        let direct = timed(&[(1.0, 1.0), (4.0, 0.25), (16.0, 0.0625)], 0.0);
        let never = timed(&[(1.0, 1.0), (2.0, 0.5)], 0.0);
        let curves = [root, direct, never];
        let (times, ties) = soonest(&curves, 0.125, any);
        assert_eq!((times.len(), ties), (2, 1));
        for (found, (curve, steps)) in times.iter().zip([(1, 8.0), (0, 64.0)]) {
            assert_eq!(found.curve, curve);
            assert!((found.parameter - steps).abs() < 1e-9, "{found:?}");
            assert!(
                (found.time.value - steps / 1000.0).abs() < 1e-12,
                "{found:?}"
            );
        }
        assert_eq!(soonest(&curves, 1e-9, any), (Vec::new(), 0));
        let exact = timed(&[(1.0, 0.5), (2.0, 0.0)], 0.0);
        assert_eq!(soonest(&[exact], 1e-9, any).0[0].parameter, 2.0);
    }

    /// One over the square root reaches 0.19 with 27.7 steps: the next number is 28, and the next square 36. A method that can take none before the point measured next is measured there.
    #[test]
    fn the_work_for_an_error_is_a_number_that_the_method_takes() {
        let curves = [timed(&[(16.0, 0.25), (256.0, 0.0625)], 0.0)];
        let square = |number: f64| number.sqrt().ceil() * number.sqrt().ceil();
        let of = |error, next: fn(f64) -> f64| soonest(&curves, error, |_, n| next(n)).0[0];
        for (error, next, steps) in [
            (0.19, f64::ceil as fn(f64) -> f64, 28.0),
            (0.19, square, 36.0),
            (0.07, |_| 1e3, 256.0),
        ] {
            let found = of(error, next);
            assert_eq!(found.parameter, steps);
            assert!((found.time.value - steps / 1000.0).abs() < 1e-12);
        }
    }

    /// The second point's time is longer at its low end than the first point's, so that the better ends reach the
    /// error later.
    #[test]
    fn an_interval_holds_its_middle() {
        let mut curve = timed(&[(1.0, 0.2), (4.0, 0.1)], 0.0);
        curve.points[1].times.seconds.low = 0.005;
        let time = soonest(&[curve], 0.1, any).0[0].time;
        assert_eq!([time.low, time.value], [0.004; 2]);
    }

    /// Ten steps and eleven are no difference, and with a noise of a third thirteen are none, either.
    #[test]
    fn times_that_are_nearly_equal_or_unsure_tie() {
        let ties = |steps: f64, noise| {
            let curves = [(10.0, 0.1), (steps, 0.1)].map(|point| timed(&[point], noise));
            soonest(&curves, 0.1, any).1
        };
        assert_eq!(
            [ties(11.0, 0.0), ties(13.0, 0.0), ties(13.0, 0.3)],
            [2, 1, 2]
        );
    }
}
