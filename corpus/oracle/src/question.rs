//! Questions in exact numbers, with all numbers changed by a fraction of themselves.

use corpus::{Question, Shape, Step};
use num_traits::{Signed, Zero};

use crate::exact::{Q, Q3, double, exact, power_of_two};
use crate::solve::{self, Problem};

/// How each number of a question is changed.
pub enum Change {
    /// Not at all.
    None,
    /// The number with this index grows by this fraction of itself, or a zero by this fraction of the
    /// greatest number beside it.
    One { index: usize, fraction: Q },
    /// All numbers grow or shrink by this fraction of themselves, as a pattern says, and zeros by this
    /// fraction of the greatest number of their triple, or of all. The same corner of several triangles
    /// changes in the same way.
    All { fraction: Q, pattern: u64 },
}

/// Reads the numbers of a question in order, and changes them.
struct Numbers<'a> {
    change: &'a Change,
    /// The greatest magnitude of all numbers but the direction's.
    greatest: f64,
    /// How many numbers were read.
    read: usize,
}

impl Numbers<'_> {
    fn number(&mut self, number: f64) -> Q {
        self.changed(number, self.read as u64, number.abs())
    }

    /// A number, whose change in a pattern depends on its name; a zero changes by a fraction of `scale`.
    fn changed(&mut self, number: f64, name: u64, scale: f64) -> Q {
        let index = self.read;
        self.read += 1;
        let unchanged = exact(number);
        let moved = |fraction: &Q| match number {
            0.0 => exact(scale) * fraction,
            _ => &unchanged * fraction,
        };
        match self.change {
            Change::One { index: i, fraction } if *i == index => &unchanged + moved(fraction),
            Change::All { fraction, pattern } => {
                if mixed(pattern ^ mixed(name)).is_multiple_of(2) {
                    &unchanged + moved(fraction)
                } else {
                    &unchanged - moved(fraction)
                }
            }
            _ => unchanged,
        }
    }

    /// The size by which the zeros of a triple change.
    fn scale(&self, numbers: [f64; 3]) -> f64 {
        let greatest = numbers.map(f64::abs).into_iter().fold(0.0, f64::max);
        if greatest == 0.0 {
            self.greatest
        } else {
            greatest
        }
    }

    fn three(&mut self, numbers: [f64; 3]) -> Q3 {
        let scale = self.scale(numbers);
        numbers.map(|number| self.changed(number, self.read as u64, scale))
    }

    fn corner(&mut self, corner: [f64; 3]) -> Q3 {
        let name = corner
            .iter()
            // Zeros of both signs are the same number.
            .fold(7, |name, x| mixed(name ^ (x + 0.0).to_bits()));
        let scale = self.scale(corner);
        let mut axis = 0;
        corner.map(|number| {
            axis += 1;
            self.changed(number, name.wrapping_add(axis), scale)
        })
    }
}

/// Mixes bits, as the generator `SplitMix64` does.
pub fn mixed(bits: u64) -> u64 {
    let mut z = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A question in exact numbers, and how many numbers it has.
pub fn problem(question: &Question, change: &Change) -> (Problem, usize) {
    let mut lengths = question.numbers();
    // The direction's length is no length of the scene.
    lengths.truncate(lengths.len() - 3);
    let mut numbers = Numbers {
        change,
        greatest: lengths
            .iter()
            .fold(0.0, |greatest, x| x.abs().max(greatest)),
        read: 0,
    };
    let shape = match &question.shape {
        Shape::Plane { point, normal } => solve::Shape::Plane {
            point: numbers.three(*point),
            normal: numbers.three(*normal),
        },
        Shape::Sphere { center, radius } => solve::Shape::Sphere {
            center: numbers.three(*center),
            radius: numbers.number(*radius),
        },
        Shape::Box { low, high } => solve::Shape::Box {
            low: numbers.three(*low),
            high: numbers.three(*high),
        },
        Shape::Disc {
            center,
            normal,
            radius,
        } => solve::Shape::Disc {
            center: numbers.three(*center),
            normal: numbers.three(*normal),
            radius: numbers.number(*radius),
        },
        Shape::Tube { from, to, radius } => solve::Shape::Tube {
            from: numbers.three(*from),
            to: numbers.three(*to),
            radius: numbers.number(*radius),
        },
        Shape::Triangles(triangles) => {
            let triangle = |corners: &[[f64; 3]; 3]| corners.map(|corner| numbers.corner(corner));
            solve::Shape::Triangles(triangles.iter().map(triangle).collect())
        }
    };
    let step = |step: &Step| match step {
        Step::Translate(by) => solve::Step::Translate(numbers.three(*by)),
        Step::Scale(by) => solve::Step::Scale(numbers.three(*by)),
    };
    let under = question.under.iter().map(step).collect();
    let problem = Problem {
        shape,
        under,
        origin: numbers.three(question.origin),
        direction: numbers.three(question.direction),
        is_closed: false,
        within: question
            .within
            .map(|end| end.is_finite().then(|| exact(end))),
    };
    (problem, numbers.read)
}

/// How far each number is changed for a derivative.
const STEP: i32 = -200;
/// The accuracy of roots from which a derivative is computed, in bits.
const BITS: u32 = 1200;

/// How far `t` moves at a part of a shape.
pub struct Conditions {
    /// The sum of `|∂t/∂x · x / t|` over all numbers x.
    pub relative: f64,
    /// The same with zeros, each as if it were the greatest number beside it.
    pub with_zeros: f64,
}

/// The conditions of `t` at a part of a shape, infinite if a change loses the hit.
pub fn conditions(question: &Question, part: solve::Part) -> Conditions {
    let infinite = Conditions {
        relative: f64::INFINITY,
        with_zeros: f64::INFINITY,
    };
    let (unchanged, count) = problem(question, &Change::None);
    let Some(t) = unchanged.t_of(part) else {
        return infinite;
    };
    if t.sign() == 0 || (!t.b.is_zero() && t.d.is_zero()) {
        return infinite;
    }
    let t = t.approximate(BITS);
    let (mut relative, mut with_zeros) = (Q::zero(), Q::zero());
    let numbers = question.numbers();
    for (index, number) in numbers.iter().enumerate().take(count) {
        let change = Change::One {
            index,
            fraction: power_of_two(STEP),
        };
        let (changed, _) = problem(question, &change);
        let Some(moved) = changed.t_of(part) else {
            return infinite;
        };
        let moved = ((moved.approximate(BITS) - &t) / &t).abs();
        if *number != 0.0 {
            relative += &moved;
        }
        with_zeros += moved;
    }
    Conditions {
        relative: double(&(relative * power_of_two(-STEP))),
        with_zeros: double(&(with_zeros * power_of_two(-STEP))),
    }
}
