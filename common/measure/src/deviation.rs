//! `Deviation`: an error, and how much of it is the problem's own.

/// The error of a computed number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The error, in the unit of the experiment.
    pub error: f64,
    /// The unit in the last place of the exact number, in the same unit; NaN if it is unknown.
    ulp: f64,
    /// The condition: by how many such units the exact number changes, if each given number
    /// changes by one in its own last place.
    condition: f64,
}

impl Deviation {
    /// An error of this `exact` number, which is a problem of this condition.
    pub fn new(error: f64, exact: f64, condition: f64) -> Self {
        Self {
            error,
            ulp: ulp(exact),
            condition,
        }
    }

    /// Given numbers and result have a precision of this epsilon.
    pub fn of_epsilon(mut self, epsilon: f64) -> Self {
        self.ulp *= epsilon / f64::EPSILON;
        self
    }

    /// The error as a fraction of a number.
    pub fn as_fraction_of(mut self, number: f64) -> Self {
        self.error /= number;
        self.ulp /= number.abs();
        self
    }

    /// The error in multiples of condition times ulp; infinite for NaN.
    pub fn error_over_condition(&self) -> f64 {
        let quotient = self.size() / self.condition;
        if quotient.is_nan() {
            f64::INFINITY
        } else {
            quotient
        }
    }

    /// Its magnitude: in units in the last place, if these are known.
    pub(crate) fn size(&self) -> f64 {
        let unit = if self.ulp.is_nan() { 1.0 } else { self.ulp };
        self.error.abs() / unit
    }
}

/// An error of a number whose condition is unknown.
impl From<f64> for Deviation {
    fn from(error: f64) -> Self {
        Self {
            error,
            ulp: f64::NAN,
            condition: f64::NAN,
        }
    }
}

/// The errors that rounding the given numbers makes already, with every formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Problem {
    /// The greatest condition.
    pub condition: f64,
    /// The root mean square of condition times unit in the last place.
    pub error: f64,
    /// The greatest quotient of an error and its condition times unit in the last place: near 1,
    /// the problem is to blame for the error, and far above, the formula.
    pub error_over_condition: f64,
}

impl Problem {
    /// The errors of some problems, if the conditions of all of them are known.
    pub(crate) fn of(all: &[Deviation]) -> Option<Self> {
        let is_known = all.iter().all(|one| one.condition > 0.0);
        if all.is_empty() || !is_known {
            return None;
        }
        let (mut condition, mut error_over_condition): (f64, f64) = (0.0, 0.0);
        for one in all {
            condition = condition.max(one.condition);
            error_over_condition = error_over_condition.max(one.error_over_condition());
        }
        Some(Self {
            condition,
            error: rms(all.iter().map(|one| one.condition * one.ulp)),
            error_over_condition,
        })
    }
}

/// The root of the mean of the squares.
pub(crate) fn rms(numbers: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = numbers.len() as f64;
    (numbers.map(|number| number * number).sum::<f64>() / count).sqrt()
}

/// The distance between a number and the next greater one.
pub(crate) fn ulp(number: f64) -> f64 {
    number.abs().next_up() - number.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{Curve, Errors, Point, Times};

    /// A point of the parameter 8, unless another is given.
    fn point(errors: impl IntoIterator<Item = Deviation>) -> Point<'static> {
        Point {
            parameter: 8.0,
            work: 1.0,
            errors: Errors::of(errors),
            times: Times::of(|| ()),
        }
    }

    fn verdict(points: impl IntoIterator<Item = Point<'static>>) -> String {
        Curve::new("", points).verdict().unwrap()
    }

    /// 6 units of a problem of condition 2, and one of condition 4.
    #[test]
    fn errors_stand_beside_those_of_the_problem() {
        let eps = f64::EPSILON;
        let of_condition_2 = Deviation::new(6.0 * eps, 1.0, 2.0);
        let all = [of_condition_2, Deviation::new(-eps, 1.0, 4.0)];
        let expected = Problem {
            condition: 4.0,
            error: 10_f64.sqrt() * eps,
            error_over_condition: 3.0,
        };
        assert_eq!(Problem::of(&all), Some(expected));
        let errors = point(all).errors;
        assert_eq!(errors.max, Some(6.0));
        assert_eq!(of_condition_2.as_fraction_of(-2.0).size(), 6.0);
        assert_eq!(of_condition_2.of_epsilon(3.0 * eps).size(), 2.0);

        let of_the_problem = verdict([point(all)]);
        let expected = "3.00 times condition · ulp: the problem is to blame";
        assert!(of_the_problem.ends_with(expected), "{of_the_problem}");
        let worse = all.map(|one| Deviation::new(1e3 * one.error, 1.0, one.condition));
        let of_the_formula = verdict([point(worse)]);
        let expected = "up to 3e3 times condition · ulp, at 8: the formula";
        assert!(of_the_formula.starts_with(expected), "{of_the_formula}");
    }

    /// One unit off at the condition 2, and at 1000.
    #[test]
    fn exact_answers_to_hard_problems_blame_nobody() {
        let points = [2.0, 1e3].map(|condition| Point {
            parameter: condition,
            ..point([Deviation::new(f64::EPSILON, 1.0, condition)])
        });
        let neither = "1e-3 times condition · ulp at 1000, the hardest: neither is to blame";
        assert_eq!(verdict(points), neither);
    }
}
