//! `Sweep`: a problem with one number that a reader turns from harmless to extreme.

use crate::exact::DoubleDouble;
use crate::extremes::{AgainstProtocol, ulp};

/// A problem that one number makes harder and harder.
pub struct Sweep {
    /// Its name.
    pub name: &'static str,
    /// The number, for a reader.
    pub parameter: &'static str,
    /// What is computed.
    pub computes: &'static str,
    /// What the picture shows.
    pub shows: &'static str,
    /// Its stage.
    pub stage: &'static str,
    /// The first and the last power of ten of the number.
    pub powers: [f64; 2],
    /// The power of ten at which the problem is harmless.
    pub harmless: f64,
    /// From one power to the next.
    pub step: f64,
    /// The length 1 of the problem, in which errors are drawn where the last place of the answer is no fixed
    /// length: it grows with the number that is turned.
    pub unit: Option<&'static str>,
    /// The exercise that asks the same, if there is one.
    pub exercise: Option<Exercise>,
    /// The problem for a value of the number.
    pub at: fn(f64) -> Point,
    /// How bright both formulas paint a place of a picture for a value of the number, from -1 to 1 to the
    /// right and upwards; `None` where they find nothing.
    pub picture: fn(f64, [f64; 2]) -> AgainstProtocol<Option<f64>>,
}

/// An exercise whose first question takes the given numbers of a [`Point`].
pub struct Exercise {
    /// The name.
    pub name: &'static str,
    /// The name of the number in its answer.
    pub part: &'static str,
}

/// The problem for one value of the number.
pub struct Point {
    /// The given numbers, in the order of the exercise's first question.
    pub given: Vec<f64>,
    /// By what number an answer of the exercise is multiplied.
    pub factor: f64,
    /// The exact answer.
    pub exact: DoubleDouble,
    /// The number in whose last place errors are counted; the exact one, but where that is 0.
    pub size: f64,
    /// The condition of the problem.
    pub condition: f64,
    /// The answers of both formulas.
    pub found: AgainstProtocol<Option<f64>>,
}

impl Point {
    /// The problem of these numbers, whose exact answer is a function of them.
    pub fn of(
        given: &[f64],
        answer: impl Fn(&[DoubleDouble]) -> DoubleDouble,
        found: AgainstProtocol<Option<f64>>,
    ) -> Self {
        let numbers: Vec<_> = given.iter().map(|x| DoubleDouble::from(*x)).collect();
        let exact = answer(&numbers);
        Self {
            given: given.to_vec(),
            factor: 1.0,
            exact,
            size: exact.value(),
            condition: condition(given, answer),
            found,
        }
    }

    /// The error of the answer, in units in its last place, if each given number is off by the largest rounding,
    /// a part of 2⁻⁵³.
    #[must_use]
    pub fn allowed(&self) -> f64 {
        self.condition * self.size.abs() * (f64::EPSILON / 2.0) / ulp(self.size)
    }

    /// The error of an answer, in units in the last place; infinite without an answer.
    pub fn error(&self, found: Option<f64>) -> f64 {
        let error = found.map_or(f64::NAN, |found| self.exact.error_of(found).abs());
        if error.is_finite() {
            error / ulp(self.size)
        } else {
            f64::INFINITY
        }
    }
}

impl Sweep {
    /// All powers of ten, from the first to the last.
    pub fn powers(&self) -> impl Iterator<Item = f64> {
        let [first, last] = self.powers;
        let count = ((last - first).abs() / self.step).round() as u32;
        let step = (last - first) / f64::from(count);
        (0..=count).map(move |n| first + step * f64::from(n))
    }

    /// The problem at a power of ten.
    pub fn point(&self, power: f64) -> Point {
        (self.at)(ten_to(power))
    }

    /// A unit in the last place of a point's answer, in what errors are drawn in.
    #[must_use]
    pub fn drawn_ulp(&self, point: &Point) -> f64 {
        match self.unit {
            Some(_) => ulp(point.size),
            None => 1.0,
        }
    }

    /// The error, as drawn, of an answer that is lost: half of its digits, or half of the unit.
    #[must_use]
    pub const fn lost(&self) -> f64 {
        match self.unit {
            Some(_) => 0.5,
            None => HALF_OF_THE_DIGITS,
        }
    }

    /// The power, nearest to the harmless one, at which the protocol's answer is lost.
    pub fn breaks_at(&self) -> Option<f64> {
        let is_broken = |power: &f64| {
            let point = self.point(*power);
            point.error(point.found.theirs) * self.drawn_ulp(&point) > self.lost()
        };
        let from_harmless = |power: &f64| (power - self.harmless).abs();
        let broken = self.powers().filter(is_broken);
        broken.min_by(|a, b| from_harmless(a).total_cmp(&from_harmless(b)))
    }
}

/// An error of 25 of the 53 binary digits, in units in the last place: less than eight decimal ones are left.
const HALF_OF_THE_DIGITS: f64 = 33_554_432.0;

/// Ten to a power. A whole power is the double that is nearest to it.
pub fn ten_to(power: f64) -> f64 {
    if power.fract() == 0.0 {
        format!("1e{power}").parse().unwrap_or(f64::NAN)
    } else {
        libm::pow(10.0, power)
    }
}

/// The condition of an answer: by how many parts it changes, if each given number changes by one part.
fn condition(given: &[f64], answer: impl Fn(&[DoubleDouble]) -> DoubleDouble) -> f64 {
    const PART: f64 = 1e-20;
    let given: Vec<_> = given.iter().map(|x| DoubleDouble::from(*x)).collect();
    let before = answer(&given);
    let mut condition = 0.0;
    for (index, number) in given.iter().enumerate() {
        let mut changed = given.clone();
        changed[index] = *number + *number * PART.into();
        let change = (answer(&changed) - before) / before;
        condition += change.value().abs() / PART;
    }
    condition
}

/// The angle of a tangent, with about 30 digits: a step of Newton's method from a double.
pub fn arc_tangent(tangent: DoubleDouble) -> DoubleDouble {
    let near = DoubleDouble::from(libm::atan(tangent.value()));
    let off = self::tangent(near) - tangent;
    near - off / (DoubleDouble::from(1.0) + tangent * tangent)
}

/// The tangent of an angle up to a right one, with about 30 digits, by the series of sine and cosine.
pub fn tangent(angle: DoubleDouble) -> DoubleDouble {
    let (mut sums, mut term) = ([DoubleDouble::from(0.0); 2], DoubleDouble::from(1.0));
    for n in 0..32_u32 {
        let sum = &mut sums[n as usize % 2];
        *sum = if n % 4 < 2 { *sum + term } else { *sum - term };
        term = term * angle / f64::from(n + 1).into();
    }
    let [cosine, sine] = sums;
    sine / cosine
}
