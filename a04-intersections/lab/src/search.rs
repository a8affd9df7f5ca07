//! `search`: looks for the ray and the shape at which a formula is worst.
//!
//! It starts over several times: a quarter of the inputs are new, and the others change a number of the worst one so
//! far, a climb, by turns towards a greater error and towards a greater condition. New inputs are random bit patterns of
//! all sizes, or special numbers: zeros, equal ones, neighbours of these, and the least and greatest sizes, with rays that
//! meet borders. Errors count in multiples of condition times ulp, so that the search
//! finds faults of the formula and no hard problems. Interval arithmetic proves decisions wrong, and an infinite
//! `t` is always wrong.

use a03_rays_cameras::Ray;
use common::Error;
use measure::experiment::Deviation;

use crate::line::{Line, line};
use crate::subject::{ExactHit, triple};
pub use crate::subject::{SUBJECTS, Subject};
use crate::support::{Numbers, Triple, point, vector};
use a04_intersections::Interval;

/// The least `t` of which 30 digits are known.
const LEAST: f64 = 1e-250;

/// Sixteen roundings: a formula may be wrong by as much as if the given numbers were.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// How many changes of an input are tried.
const TRIALS: usize = 150;

/// Which numbers are changed, and by roundings of what.
#[derive(Clone, Copy)]
enum Change {
    /// Each number by its own roundings, as its condition counts them.
    Own,
    /// The same, and a zero by those of the greatest number beside it.
    Each,
    /// Each number by roundings of the greatest one beside it.
    Beside,
    /// The same, of the shape alone.
    Shape,
}

const CHANGES: [Change; 3] = [Change::Each, Change::Beside, Change::Shape];

/// Numbers of a shape below this are not searched.
const TINY: f64 = 1e-290;

/// An error of so many times condition and ulp may be a hit on another part of the shape.
const SUSPICIOUS: f64 = 16.0;

/// Finds the `t` of the nearest hit of the shape that some numbers describe.
type Formula<'a> = &'a dyn Fn(&[f64], &Ray) -> Option<f64>;

/// The worst inputs of a formula.
#[derive(Debug, Default)]
pub struct Worst {
    /// The greatest error, in multiples of condition times ulp.
    pub error: f64,
    /// The input at which the error is greatest.
    pub input: Option<Input>,
    /// Inputs at which the formula hits or misses wrongly, the first ones.
    pub wrong: Vec<Input>,
    /// The same, where the exact decision is another one if the given numbers change by some roundings: the ray
    /// meets a border, or starts on the shape.
    pub borders: Vec<Input>,
    /// An input for which the formula finds a hit at an infinite `t`, or at none.
    pub endless: Option<Input>,
}

/// The numbers of a shape, and six of a ray: its origin, and its direction of any length.
pub type Input = Vec<f64>;

/// The number of inputs of a search, a quarter of them new.
pub const INPUTS: usize = 200_000;

/// How often a search starts over.
const STARTS: usize = 8;

/// After so many wrong decisions no more are looked for.
const ENOUGH: usize = 50;

/// How many inputs of wrong decisions are kept.
const KEPT: usize = 1_000;

/// What a formula makes of an input.
enum Answer {
    /// It hits or misses wrongly.
    Wrong,
    /// It hits where there is none, or the opposite: wrongly, or at a border.
    Differs { is_hit: bool },
    /// It hits or misses wrongly, where the rounding of the given numbers decides.
    Border,
    /// It finds a hit at an infinite `t`, or at none.
    Endless,
    /// It finds a hit, with an error in multiples of condition times ulp.
    Hit { error: f64, condition: f64 },
    /// It misses as it should, or nothing proves the decision.
    Other,
}

/// The quantity that a climb makes greater.
#[derive(Clone, Copy)]
enum Goal {
    Error,
    Condition,
}

/// The input of a climb that is best so far.
#[derive(Default)]
struct Best {
    value: f64,
    input: Option<Input>,
}

impl Worst {
    /// Takes note of an answer.
    fn note(&mut self, answer: &Answer, input: &Input) {
        match answer {
            Answer::Wrong if self.wrong.len() < KEPT => self.wrong.push(input.clone()),
            Answer::Border if self.borders.len() < KEPT => self.borders.push(input.clone()),
            Answer::Endless => {
                self.endless.get_or_insert_with(|| input.clone());
            }
            Answer::Hit { error, .. } if *error > self.error => {
                self.error = *error;
                self.input = Some(input.clone());
            }
            Answer::Wrong
            | Answer::Differs { .. }
            | Answer::Border
            | Answer::Hit { .. }
            | Answer::Other => {}
        }
    }
}

impl Subject {
    /// How many numbers describe the shape.
    fn numbers(&self) -> usize {
        self.written.matches('#').count()
    }

    /// The worst input of a formula for the `t` of the nearest hit.
    pub fn worst(&self, formula: Formula, inputs: usize) -> Worst {
        let (mut numbers, mut worst) = (Numbers::new(71, 0), Worst::default());
        let climb = inputs / STARTS;
        for start in 0..STARTS {
            let goal = if start % 2 == 0 {
                Goal::Error
            } else {
                Goal::Condition
            };
            let mut best = Best::default();
            for n in 0..climb {
                let mut input = self.new_input(&mut numbers);
                if let Some(best) = &best.input
                    && n > climb / 4
                {
                    input = changed(best, &input, &mut numbers);
                }
                let mut answer = self.answer(formula, &input);
                if let Answer::Differs { is_hit } = answer {
                    // Trials take time.
                    let is_known = worst.wrong.len() >= ENOUGH;
                    answer = if is_known {
                        Answer::Other
                    } else if self.is_border(&input, is_hit) {
                        Answer::Border
                    } else {
                        Answer::Wrong
                    };
                }
                if let Answer::Hit { error, .. } = answer
                    && error > SUSPICIOUS.max(worst.error.min(best.value))
                {
                    // A new worst input, unless the nearest hit is not certain. Trials take time.
                    if self.jumps(&input) {
                        answer = Answer::Border;
                    } else if error.is_infinite() {
                        answer = Answer::Wrong;
                    }
                }
                worst.note(&answer, &input);
                if let Answer::Hit { error, condition } = answer {
                    let value = match goal {
                        Goal::Error => error,
                        Goal::Condition => condition,
                    };
                    if value.is_finite() && value > best.value {
                        best = Best {
                            value,
                            input: Some(input),
                        };
                    }
                }
            }
        }
        worst
    }

    /// An input of random bits or of special numbers.
    fn new_input(&self, numbers: &mut Numbers) -> Input {
        if numbers.below(2) == 0 {
            self.random_input(numbers)
        } else {
            self.special_input(numbers)
        }
    }

    /// Numbers of one size or of many, and a ray that aims at the shape.
    fn random_input(&self, numbers: &mut Numbers) -> Input {
        // Half of the sizes are usual ones.
        let (middle, width) = if numbers.below(2) == 0 {
            (0, 20)
        } else {
            (numbers.below(601) as i32 - 300, numbers.below(21))
        };
        let least = middle - numbers.below(width + 1) as i32;
        let most = middle + numbers.below(width + 1) as i32;
        let mut input = Vec::new();
        for _ in 0..self.numbers() + 3 {
            input.push(bits(numbers, least, most));
        }
        let aim = [0; 3].map(|_| numbers.between(-1.0, 1.0));
        let target = (self.aim)(&input[..self.numbers()], aim);
        self.aimed(input, target)
    }

    /// Special numbers, and a ray that often lies along an axis and meets a border.
    fn special_input(&self, numbers: &mut Numbers) -> Input {
        let mut input = Vec::new();
        for _ in 0..self.numbers() {
            let number = special(&input, numbers);
            input.push(number);
        }
        let target = if numbers.below(2) == 0 {
            let aim = [0; 3].map(|_| numbers.below(3) as f64 - 1.0);
            (self.aim)(&input, aim)
        } else {
            [0; 3].map(|_| special(&input, numbers))
        };
        if numbers.below(2) == 0 {
            (self.through)(&mut input, target);
        }
        let mut origin = target;
        let along = numbers.below(3);
        let is_along_an_axis = numbers.below(2) == 0;
        for (axis, coordinate) in origin.iter_mut().enumerate() {
            if !is_along_an_axis || axis == along {
                *coordinate = special(&input, numbers);
            }
        }
        input.extend(origin);
        if numbers.below(4) == 0 {
            let direction = [0; 3].map(|_| special(&input, numbers));
            input.extend(direction);
            input
        } else {
            self.aimed(input, target)
        }
    }

    /// The numbers of a shape and an origin, with the direction to a target.
    fn aimed(&self, mut input: Input, target: Triple) -> Input {
        let origin = triple(&input[self.numbers()..]);
        input.extend([0, 1, 2].map(|axis| target[axis] - origin[axis]));
        input
    }

    /// The ray of an input; `None` without a direction.
    fn ray(&self, input: &[f64]) -> Option<Ray> {
        let (_, ray) = input.split_at(self.numbers());
        let direction = vector(triple(&ray[3..])).normalized()?;
        Some(Ray::derived(point(triple(ray)), direction))
    }

    fn answer(&self, formula: Formula, input: &[f64]) -> Answer {
        if input.iter().any(|number| !number.is_finite()) {
            return Answer::Other;
        }
        let Some(ray) = self.ray(input) else {
            return Answer::Other;
        };
        if self.is_tiny(input) || (self.make)(&input[..self.numbers()]).is_none() {
            return Answer::Other;
        }
        let found = formula(input, &ray);
        if found.is_some_and(|t| !t.is_finite()) {
            return Answer::Endless;
        }
        let Some(is_hit) = self.is_hit(input, &ray) else {
            return Answer::Other;
        };
        if found.is_some() != is_hit {
            return Answer::Differs { is_hit };
        }
        let (Some(found), Some(exact)) = (found, self.certain(input, &ray)) else {
            return Answer::Other;
        };
        let error = exact.t.error_of(found);
        let error = Deviation::new(error, exact.t.value(), exact.condition);
        // With a greater condition the given numbers have not one digit of t; without one, doubles do not tell the hit
        // from the middle of the shape.
        if !(exact.condition > 0.0 && exact.condition * ROUNDINGS < 1.0) {
            return Answer::Other;
        }
        let error = error.error_over_condition();
        Answer::Hit {
            error,
            condition: exact.condition,
        }
    }

    /// Whether the decision may be another one if the numbers change by some roundings, as far as trials show.
    fn is_border(&self, input: &[f64], is_hit: bool) -> bool {
        let mut numbers = Numbers::new(72, 0);
        (0..TRIALS).any(|n| {
            let changed = self.rounded(input, CHANGES[n % CHANGES.len()], &mut numbers);
            let ray = self.ray(&changed);
            let decision = ray.and_then(|ray| self.is_hit(&changed, &ray));
            decision != Some(is_hit)
        })
    }

    /// Whether the nearest hit may be another one: whether `t` moves by far more than its condition says.
    fn jumps(&self, input: &[f64]) -> bool {
        let mut numbers = Numbers::new(73, 0);
        let ray = self.ray(input);
        let Some(exact) = ray.and_then(|ray| (self.exact)(input, &Line::of(&ray))) else {
            return true;
        };
        let t = exact.t.value();
        let allowed = 4.0 * exact.condition.max(1.0) * ROUNDINGS * t;
        (0..TRIALS).any(|_| {
            let changed = self.rounded(input, Change::Own, &mut numbers);
            let ray = self.ray(&changed);
            let moved = ray.and_then(|ray| (self.exact)(&changed, &Line::of(&ray)));
            moved.is_none_or(|moved| (moved.t.value() - t).abs() > allowed)
        })
    }

    /// The input with its numbers changed by some roundings.
    fn rounded(&self, input: &[f64], change: Change, numbers: &mut Numbers) -> Input {
        let count = self.numbers();
        let mut changed = Vec::new();
        for (index, number) in input.iter().enumerate() {
            // The triple of a number: of the shape, where a radius stands alone; the origin; the direction.
            let (from, to) = if index < count {
                (index / 3 * 3, (index / 3 * 3 + 3).min(count))
            } else {
                let from = count + (index - count) / 3 * 3;
                (from, from + 3)
            };
            let greatest = input[from..to].iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            let own = if *number == 0.0 {
                greatest
            } else {
                number.abs()
            };
            let size = match change {
                Change::Own => number.abs(),
                Change::Each => own,
                Change::Beside => own.max(greatest),
                Change::Shape if index < count => own.max(greatest),
                Change::Shape => 0.0,
            };
            changed.push(number + size * ROUNDINGS * numbers.between(-1.0, 1.0));
        }
        changed
    }

    /// Whether the shape is so tiny that its numbers have not all their digits.
    fn is_tiny(&self, input: &[f64]) -> bool {
        let lengths = &input[..self.numbers()];
        lengths.iter().all(|number| number.abs() < TINY)
    }

    /// The exact hit, unless 30 digits leave the range of doubles: it is the same if all lengths are some powers of
    /// two times as large.
    fn certain(&self, input: &[f64], ray: &Ray) -> Option<ExactHit> {
        let exact = (self.exact)(input, &Line::of(ray))?;
        let t = exact.t.value();
        if !(LEAST..1.0 / LEAST).contains(&t) {
            return None;
        }
        for power in [-100, 100] {
            let scaled = |x: &f64| libm::scalbn(*x, power);
            let numbers: Input = input.iter().map(scaled).collect();
            let (shape, ray_numbers) = numbers.split_at(self.numbers());
            let line = line(triple(ray_numbers), Line::of(ray).direction);
            let again = (self.exact)(shape, &line)?;
            let off =
                again.t.error_of(libm::scalbn(t, power)) - libm::scalbn(exact.t.error_of(t), power);
            if off.abs() > 1e-20 * libm::scalbn(t, power).abs() {
                return None;
            }
        }
        Some(exact)
    }

    /// Whether a ray hits the shape, unless its constructor refuses the numbers or the enclosures
    /// leave it open.
    fn is_hit(&self, input: &[f64], ray: &Ray) -> Option<bool> {
        let shape = (self.make)(input)?;
        (self.decide)(&*shape, ray, Interval::AHEAD)
    }

    /// A line of Rust for a test: the ray hits and misses as it should, or its `t` is within eight
    /// times condition times ulp.
    fn test(&self, input: &[f64], is_decision: bool) -> Option<String> {
        let ray = self.ray(input)?;
        let is_hit = self.is_hit(input, &ray)?;
        let hit = self.written_hit(input, &Line::of(&ray));
        let exact = (self.exact)(input, &Line::of(&ray));
        Some(match exact.filter(|_| is_hit) {
            None => format!("assert!({hit}.is_none());"),
            Some(exact) if is_decision => {
                let t = exact.t.value();
                format!("assert!({hit}.is_some()); // t is {t:?}")
            }
            Some(exact) => {
                let t = exact.t.value();
                let bound = 8.0 * exact.condition * f64::EPSILON * t;
                let is_near = format!("(hit.t - {t:?}).abs() <= {bound:.1e}");
                format!("assert!({hit}.is_some_and(|hit| {is_near}));")
            }
        })
    }

    /// The call of `hit` in Rust.
    fn written_hit(&self, input: &[f64], line: &Line) -> String {
        let mut written = format!(
            "{}.unwrap().hit(&Ray::derived(Point3::new(#, #, #), Vector3::new(#, #, #)), \
             Interval::AHEAD)",
            self.written
        );
        let shape = &input[..self.numbers()];
        for number in shape.iter().chain(&line.origin).chain(&line.direction) {
            written = written.replacen('#', &format!("{number:?}"), 1);
        }
        written
    }

    /// The worst input in words, and as lines of Rust.
    pub fn in_words(&self, whose: &str, worst: &Worst) -> String {
        let (name, error) = (self.name, worst.error);
        let mut lines = vec![format!(
            "{name}, {whose}: off by up to {error:.1e} times condition · ulp"
        )];
        if let Some(input) = &worst.input {
            lines.extend(self.test(input, false));
        }
        if let Some(input) = worst.wrong.first()
            && let Some(test) = self.test(input, true)
        {
            lines.push("it hits or misses wrongly:".to_owned());
            lines.push(test);
        }
        if let Some(input) = worst.borders.first()
            && let Some(test) = self.test(input, true)
        {
            lines.push("it hits or misses wrongly at a border, where rounding of the given numbers decides:".to_owned());
            lines.push(test);
        }
        if let Some(input) = &worst.endless
            && let Some(ray) = self.ray(input)
        {
            let hit = self.written_hit(input, &Line::of(&ray));
            lines.push("it finds a t that is no number, or beyond all numbers:".to_owned());
            lines.push(format!(
                "assert!({hit}.is_none_or(|hit| hit.t.is_finite()));"
            ));
        }
        lines.join("\n  ")
    }
}

/// The best input with one number changed: mostly by a little, sometimes to that of a random input.
fn changed(best: &Input, random: &Input, numbers: &mut Numbers) -> Input {
    let mut input = best.clone();
    let at = numbers.below(input.len());
    let size = libm::exp2(numbers.between(-50.0, 0.0));
    let near = input[at] * (1.0 + size * numbers.between(-1.0, 1.0));
    let is_random = numbers.below(8) == 0;
    input[at] = if is_random { random[at] } else { near };
    input
}

/// A number of any sign with random digits, and an exponent between two.
fn bits(numbers: &mut Numbers, least: i32, most: i32) -> f64 {
    let sign = if numbers.below(2) == 0 { 1.0 } else { -1.0 };
    let exponent = least + numbers.below((most - least + 1) as usize) as i32;
    libm::scalbn(sign * numbers.between(1.0, 2.0), exponent)
}

/// Zeros, small whole numbers and halves.
const USUAL: [f64; 12] = [
    0.0, 0.0, 0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 3.0, 4.0, 0.5, -0.25,
];

/// The least and greatest sizes: of doubles, and those at which squares leave their range.
const RARE: [f64; 8] = [5e-324, -5e-324, 1e-300, 1e-160, 1e-100, 1e100, 1e150, 1e300];

/// A number that is special, or equal to one of these, or next to it.
fn special(others: &[f64], numbers: &mut Numbers) -> f64 {
    let number = match numbers.below(24) {
        0..=5 if !others.is_empty() => others[numbers.below(others.len())],
        6 => RARE[numbers.below(RARE.len())],
        _ => USUAL[numbers.below(USUAL.len())],
    };
    match numbers.below(16) {
        0 => number.next_up(),
        1 => number.next_down(),
        _ => number,
    }
}

/// The worst inputs of the formulas of a shape of this stage, in words and as lines of Rust.
pub fn search(name: &str) -> Result<String, Error> {
    search_among(&SUBJECTS, name)
}

/// The worst inputs of the protocol's formula and the lesson's, for the shape of this name.
pub fn search_among(subjects: &[Subject], name: &str) -> Result<String, Error> {
    let subject = Subject::named(subjects, name)?;
    let theirs = subject.worst(&subject.protocol, INPUTS);
    let theirs = subject.in_words("the protocol's formula", &theirs);
    let ours = subject.worst(&|input, ray| subject.lesson(input, ray), INPUTS);
    let ours = subject.in_words("the lesson's formula", &ours);
    Ok(format!("{theirs}\n{ours}"))
}
