//! `Quantity`: a direction that some numbers give, such as an axis of a camera, and the search for the numbers at
//! which a formula for it is worst.
//!
//! As the search for shapes in stage 4, it starts over, at random bit patterns of all sizes and at special numbers, and
//! climbs by turns towards a greater error and a greater condition.

use a02_lab::condition::{Exact3, condition, dot};
use a02_lab::exact::DoubleDouble;
use a03_rays_cameras::PixelRandom;
use common::Error;

/// A direction of length 1, as a function of some numbers.
pub struct Quantity {
    pub name: &'static str,
    /// The lesson's call in Rust, with `#` for each number.
    pub written: &'static str,
    /// The direction with 30 digits; not finite where there is none.
    pub exact: fn(&[DoubleDouble]) -> Exact3,
    /// The lesson's, unless it refuses the numbers.
    pub lesson: Formula,
    /// The protocol's, which may be no number.
    pub protocol: Formula,
}

/// Finds the direction of some numbers.
pub type Formula = fn(&[f64]) -> Option<[f64; 3]>;

/// The worst numbers for a formula.
#[derive(Debug, Default)]
pub struct Worst {
    /// The greatest error, in multiples of condition times ulp of the greatest coordinate.
    pub error: f64,
    /// The numbers at which it is greatest.
    pub input: Option<Vec<f64>>,
    /// Numbers for which the formula gives no numbers.
    pub lost: Option<Vec<f64>>,
}

/// How many inputs are tried, a quarter of them new.
pub const INPUTS: usize = 40_000;

/// How often the search starts over.
const STARTS: usize = 8;

/// With a greater condition the given numbers have no digits of the result.
const GREATEST_CONDITION: f64 = 1e14;

/// Random numbers that are the same in every run.
struct Random {
    numbers: PixelRandom,
    drawn: u64,
}

impl Random {
    fn below(&mut self, count: usize) -> usize {
        (self.between(0.0, 1.0) * count as f64) as usize
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.drawn += 1;
        least + (most - least) * self.numbers.uniform(self.drawn)
    }
}

impl Quantity {
    fn count(&self) -> usize {
        self.written.matches('#').count()
    }

    /// The numbers at which a formula is worst.
    pub fn worst(&self, formula: Formula) -> Worst {
        let numbers = PixelRandom::new(74, 0, 0);
        let mut random = Random { numbers, drawn: 0 };
        let mut worst = Worst::default();
        let climb = INPUTS / STARTS;
        for start in 0..STARTS {
            let mut best: Option<(f64, Vec<f64>)> = None;
            for n in 0..climb {
                let mut input = self.new_input(&mut random);
                if let Some((_, best)) = &best
                    && n > climb / 4
                {
                    let at = random.below(input.len());
                    let size = libm::exp2(random.between(-50.0, 0.0));
                    let mut near = best.clone();
                    near[at] = match random.below(8) {
                        0 => input[at],
                        _ => near[at] * (1.0 + size * random.between(-1.0, 1.0)),
                    };
                    input = near;
                }
                let Some(of_input) = self.condition_and_error(formula, &input, &mut worst) else {
                    continue;
                };
                let [condition, error] = of_input;
                if error > worst.error {
                    worst.error = error;
                    worst.input = Some(input.clone());
                }
                let value = if start % 2 == 0 { error } else { condition };
                if best.as_ref().is_none_or(|(best, _)| value > *best) {
                    best = Some((value, input));
                }
            }
        }
        worst
    }

    /// Numbers of one size or of many, or special ones.
    fn new_input(&self, random: &mut Random) -> Vec<f64> {
        /// Zeros, small whole numbers, and the sizes at which squares leave the range of doubles.
        const SPECIAL: [f64; 16] = [
            0.0, 0.0, 0.0, -0.0, 1.0, 1.0, -1.0, 2.0, -2.0, 3.0, 0.5, 1e-300, 1e-160, 1e-100,
            1e100, 1e200,
        ];
        let is_special = random.below(2) == 0;
        let middle = random.below(601) as f64 - 300.0;
        let middle = if random.below(2) == 0 { 0.0 } else { middle };
        let mut input: Vec<f64> = Vec::new();
        for _ in 0..self.count() {
            let number = if !is_special {
                let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
                let exponent = (middle + random.between(-10.0, 10.0)) as i32;
                libm::scalbn(sign * random.between(1.0, 2.0), exponent)
            } else if !input.is_empty() && random.below(4) == 0 {
                input[random.below(input.len())]
            } else {
                SPECIAL[random.below(SPECIAL.len())]
            };
            input.push(match random.below(16) {
                0 => number.next_up(),
                1 => number.next_down(),
                _ => number,
            });
        }
        input
    }

    /// The condition and the error of a formula, unless it refuses the numbers, or they have no digits of the result.
    fn condition_and_error(
        &self,
        formula: Formula,
        input: &[f64],
        worst: &mut Worst,
    ) -> Option<[f64; 2]> {
        let found = formula(input)?;
        let numbers: Vec<_> = input.iter().map(|x| DoubleDouble::from(*x)).collect();
        let exact = (self.exact)(&numbers);
        let condition = condition(input, self.exact).max(1.0);
        let is_certain = exact.iter().all(|x| x.value().is_finite());
        if !is_certain || !(1.0..GREATEST_CONDITION).contains(&condition) {
            return None;
        }
        if found.iter().any(|x| !x.is_finite()) {
            worst.lost.get_or_insert_with(|| input.to_vec());
            return None;
        }
        let mut error: f64 = 0.0;
        for (exact, found) in exact.into_iter().zip(found) {
            error = error.max(exact.error_of(found).abs());
        }
        // The greatest coordinate of a direction lies between 1/2 and 1, whose ulp is ε/2.
        Some([condition, error / (0.5 * f64::EPSILON * condition)])
    }

    /// The worst numbers in words, as the lesson's call in Rust.
    fn in_words(&self, whose: &str, worst: &Worst) -> String {
        let call = |input: &[f64]| {
            let mut written = self.written.to_owned();
            for number in input {
                written = written.replacen('#', &format!("{number:?}"), 1);
            }
            written
        };
        let (name, error) = (self.name, worst.error);
        let mut lines = vec![format!(
            "{name}, {whose}: off by up to {error:.1e} times condition · ulp"
        )];
        lines.extend(worst.input.as_deref().map(call));
        if let Some(input) = &worst.lost {
            lines.push("it gives no numbers for:".to_owned());
            lines.push(call(input));
        }
        lines.join("\n  ")
    }

    /// The worst numbers for the protocol's formula and the lesson's, in words.
    ///
    /// # Errors
    ///
    /// If another quantity is asked for.
    pub fn search(&self, name: &str) -> Result<String, Error> {
        if name != self.name {
            return Err(Error::Usage(format!(
                "no \"{name}\" is searched here, only {}",
                self.name
            )));
        }
        let theirs = self.in_words("the protocol's formula", &self.worst(self.protocol));
        let ours = self.in_words("the lesson's formula", &self.worst(self.lesson));
        Ok(format!("{theirs}\n{ours}"))
    }
}

/// The vector in this direction of length 1, for any length.
pub fn unit(vector: Exact3) -> Exact3 {
    let greatest = vector
        .map(|x| x.value().abs())
        .into_iter()
        .fold(0.0, f64::max);
    if greatest == 0.0 || !greatest.is_finite() {
        return [DoubleDouble::from(f64::NAN); 3];
    }
    // Two steps, each of which is a power of two that is a double.
    let power = -libm::ilogb(greatest);
    let [half, rest] =
        [power / 2, power - power / 2].map(|power| DoubleDouble::from(libm::scalbn(1.0, power)));
    let near_one = vector.map(|x| x * half * rest);
    let length = dot(near_one, near_one).sqrt();
    near_one.map(|x| x / length)
}
