//! `search`: looks for the ray and the shape at which a formula is worst.
//!
//! Half of the inputs are random bit patterns; each of the others changes a number of the worst
//! input so far, a climb. Errors count in multiples of condition times ulp, so that the search
//! finds faults of the formula and no hard problems. Interval arithmetic proves decisions wrong.

use a03_rays_cameras::Ray;
use common::Error;
use measure::experiment::Deviation;

use crate::line::Line;
use crate::subject::triple;
pub use crate::subject::{SUBJECTS, Subject};
use crate::support::{Numbers, point};
use a04_intersections::Interval;

/// Finds the `t` of the nearest hit of the shape that some numbers describe.
type Formula<'a> = &'a dyn Fn(&[f64], &Ray) -> Option<f64>;

/// The worst inputs of a formula.
#[derive(Debug, Default)]
pub struct Worst {
    /// The greatest error, in multiples of condition times ulp.
    pub error: f64,
    /// The input at which the error is greatest.
    pub input: Option<Input>,
    /// The first input at which the formula hits or misses wrongly.
    pub wrong: Option<Input>,
}

/// The numbers of a shape, and six of a ray: its origin, and where it aims.
type Input = Vec<f64>;

/// The number of inputs of a search, half of them random.
pub const INPUTS: usize = 200_000;

/// What a formula makes of an input.
enum Answer {
    /// It hits or misses wrongly.
    Wrong,
    /// It finds a hit, with an error in multiples of condition times ulp.
    Hit { error: f64 },
    /// It misses as it should, or nothing proves the decision.
    Other,
}

impl Subject {
    /// How many numbers describe the shape.
    fn numbers(&self) -> usize {
        self.written.matches('#').count()
    }

    /// The worst input of a formula for the `t` of the nearest hit.
    pub fn worst(&self, formula: Formula, inputs: usize) -> Worst {
        let (mut numbers, mut worst) = (Numbers::new(71, 0), Worst::default());
        for n in 0..inputs {
            let mut input = self.random_input(&mut numbers);
            if let Some(best) = &worst.input
                && n > inputs / 2
            {
                input = changed(best, &input, &mut numbers);
            }
            match self.answer(formula, &input) {
                Answer::Wrong => {
                    worst.wrong.get_or_insert(input);
                }
                Answer::Hit { error } if error > worst.error => {
                    worst.error = error;
                    worst.input = Some(input);
                }
                _ => {}
            }
        }
        worst
    }

    /// Numbers of one size or of many, and a ray that aims at the shape.
    fn random_input(&self, numbers: &mut Numbers) -> Input {
        let least = numbers.below(41);
        let most = numbers.below(41).max(least);
        let aim = self.numbers() + 3;
        let mut input = Vec::new();
        for _ in 0..aim + 3 {
            input.push(bits(numbers, least, most));
        }
        for number in &mut input[aim..] {
            *number = numbers.between(-1.0, 1.0);
        }
        input
    }

    fn ray(&self, input: &[f64]) -> Ray {
        let (shape, ray) = input.split_at(self.numbers());
        let origin = point(triple(ray));
        let target = point((self.aim)(shape, triple(&ray[3..])));
        let towards = target - origin;
        Ray::derived(origin, towards * (1.0 / towards.magnitude()))
    }

    fn answer(&self, formula: Formula, input: &[f64]) -> Answer {
        let ray = self.ray(input);
        let Some(is_hit) = self.is_hit(input, &ray) else {
            return Answer::Other;
        };
        let found = formula(input, &ray);
        if found.is_some() != is_hit {
            return Answer::Wrong;
        }
        let exact = (self.exact)(input, &Line::of(&ray));
        let (Some(found), Some(exact)) = (found, exact) else {
            return Answer::Other;
        };
        let error = exact.t.error_of(found);
        let error = Deviation::new(error, exact.t.value(), exact.condition);
        match error.error_over_condition() {
            f64::INFINITY => Answer::Wrong,
            error => Answer::Hit { error },
        }
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
        let ray = self.ray(input);
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
        if let Some(input) = &worst.wrong
            && let Some(test) = self.test(input, true)
        {
            lines.push("it hits or misses wrongly:".to_owned());
            lines.push(test);
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

/// A number of any sign with random digits, and an exponent between two that are greater by 20.
fn bits(numbers: &mut Numbers, least: usize, most: usize) -> f64 {
    let sign = if numbers.below(2) == 0 { 1.0 } else { -1.0 };
    let exponent = least + numbers.below(most - least + 1);
    libm::scalbn(sign * numbers.between(1.0, 2.0), exponent as i32 - 20)
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
