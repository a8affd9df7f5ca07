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
    pub fn as_share_of(mut self, number: f64) -> Self {
        (self.error, self.ulp) = (self.error / number, self.ulp / number.abs());
        self
    }

    /// The error in multiples of condition times ulp; infinite for NaN.
    pub fn fault(&self) -> f64 {
        let fault = self.size() / self.condition;
        if fault.is_nan() { f64::INFINITY } else { fault }
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
        let [ulp, condition] = [f64::NAN; 2];
        Self {
            error,
            ulp,
            condition,
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
    pub fault: f64,
}

impl Problem {
    pub(crate) fn of(all: &[Deviation]) -> Option<Self> {
        let greatest = |number: fn(&Deviation) -> f64| all.iter().map(number).fold(0.0, f64::max);
        let is_known = all.iter().all(|one| one.condition > 0.0);
        (is_known && !all.is_empty()).then(|| Self {
            condition: greatest(|one| one.condition),
            error: rms(all.iter().map(|one| one.condition * one.ulp)),
            fault: greatest(Deviation::fault),
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
    use crate::experiment::{Curve, Point};

    /// 6 units of a problem of condition 2, and one of condition 4.
    #[test]
    fn errors_stand_beside_those_of_the_problem() {
        let eps = f64::EPSILON;
        let all = [(6.0, 2.0), (-1.0, 4.0)].map(|(units, c)| Deviation::new(units * eps, 1.0, c));
        let problem = Problem::of(&all).unwrap();
        let expected = [4.0, 10_f64.sqrt() * eps, 3.0];
        assert_eq!([problem.condition, problem.error, problem.fault], expected);
        let point = |errors: [Deviation; 2]| Point::new(8.0, 1.0, errors, || ());
        assert_eq!((point(all).p99, point(all).max), (6.0, 6.0));
        let blame = |errors| Curve::new("", [point(errors)]).blame().unwrap();
        assert!(blame(all).ends_with("3.00 times condition · ulp: the problem is to blame"));
        let worse = all.map(|one| Deviation::new(1e3 * one.error, 1.0, one.condition));
        assert!(blame(worse).starts_with("up to 3e3 times condition · ulp, at 8: the formula"));
        // One unit off at the condition 2, and at 1000.
        let exact = [2.0, 1e3].map(|c| Point::new(c, 1.0, [Deviation::new(eps, 1.0, c)], || ()));
        let neither = "1e-3 times condition · ulp at 1000, the hardest: neither is to blame";
        assert_eq!(Curve::new("", exact).blame().unwrap(), neither);
        assert_eq!(all[0].as_share_of(-2.0).size(), 6.0);
        assert_eq!(all[0].of_epsilon(3.0 * eps).size(), 2.0);
    }
}
