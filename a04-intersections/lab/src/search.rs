//! `search`: looks for the ray and the shape at which a formula is worst.
//!
//! Half of the inputs are random bit patterns; each of the others changes a number of the worst
//! input so far, a climb. Errors count in multiples of condition times ulp, so that the search
//! finds faults of the formula and no hard problems. Interval arithmetic proves decisions wrong.

use a03_rays_cameras::Ray;
use common::Error;
use measure::experiment::Deviation;

use super::subject::triple;
pub use super::subject::{SUBJECTS, Subject};
use super::support::{Numbers, arrays, point};
use a04_intersections::Interval;

/// Finds the `t` of the nearest hit of the shape that some numbers describe.
type Formula<'a> = &'a dyn Fn(&[f64], &Ray) -> Option<f64>;

/// The worst input of a formula, with its error in multiples of condition times ulp; and the first
/// input at which it hits or misses wrongly.
#[derive(Debug, Default)]
pub struct Worst {
    pub error: f64,
    pub input: Option<Input>,
    pub wrong: Option<Input>,
}

/// The numbers of a shape, and six of a ray.
type Input = Vec<f64>;

/// The number of inputs of a search, half of them random.
pub const INPUTS: usize = 200_000;

impl Subject {
    fn numbers(&self) -> usize {
        self.written.matches('#').count()
    }

    /// The worst input of a formula for the `t` of the nearest hit.
    pub fn worst(&self, formula: Formula, inputs: usize) -> Worst {
        let (mut numbers, mut worst) = (Numbers::new(71, 0), Worst::default());
        for n in 0..inputs {
            // Of one size or of many.
            let least = numbers.below(41);
            let sizes = [least, numbers.below(41).max(least)];
            let bits = |_| bits(&mut numbers, sizes);
            let mut input: Vec<_> = (0..self.numbers() + 6).map(bits).collect();
            let aim = self.numbers() + 3;
            (aim..aim + 3).for_each(|i| input[i] = numbers.between(-1.0, 1.0));
            if let Some(best) = worst.input.as_ref().filter(|_| n > inputs / 2) {
                let changed = numbers.below(input.len());
                let random = std::mem::replace(&mut input, best.clone())[changed];
                let size = libm::exp2(numbers.between(-50.0, 0.0));
                let near = input[changed] * (1.0 + size * numbers.between(-1.0, 1.0));
                input[changed] = if numbers.below(8) == 0 { random } else { near };
            }
            match self.error(formula, &input) {
                Some(f64::INFINITY) => drop(worst.wrong.get_or_insert(input)),
                Some(error) if error > worst.error => {
                    (worst.error, worst.input) = (error, Some(input));
                }
                _ => {}
            }
        }
        worst
    }

    fn ray(&self, input: &[f64]) -> Ray {
        let (shape, ray) = input.split_at(self.numbers());
        let (o, to) = (point(triple(ray)), point((self.aim)(shape, &ray[3..])));
        Ray::derived(o, (to - o) * (1.0 / (to - o).magnitude()))
    }

    /// Infinite where the formula hits or misses wrongly.
    fn error(&self, formula: Formula, input: &[f64]) -> Option<f64> {
        let (shape, ray) = ((self.make)(input)?, self.ray(input));
        let is_hit = (self.decide)(&*shape, &ray, Interval::AHEAD)?;
        let found = formula(input, &ray);
        if found.is_some() != is_hit {
            return Some(f64::INFINITY);
        }
        let (t, condition) = (self.exact)(input, &arrays(&ray))?;
        Some(Deviation::new(t.error_of(found?), t.value(), condition).fault())
    }

    /// A line of Rust for a test: the ray hits and misses as it should, or its `t` is within eight
    /// times condition times ulp.
    fn test(&self, input: &[f64], is_decision: bool) -> Option<String> {
        let (shape, ray) = ((self.make)(input)?, self.ray(input));
        let line @ [o, d] = arrays(&ray);
        let written = format!(
            "assert!({}.unwrap().hit(&Ray::derived(Point3::new(#, #, #), Vector3::new(#, #, #)), \
             Interval::AHEAD)",
            self.written
        );
        let all = input[..self.numbers()].iter().chain(&o).chain(&d);
        let written = all.fold(written, |text, x| text.replacen('#', &format!("{x:?}"), 1));
        let is_hit = (self.decide)(&*shape, &ray, Interval::AHEAD)?;
        Some(match (self.exact)(input, &line).filter(|_| is_hit) {
            None => format!("{written}.is_none());"),
            Some((t, _)) if is_decision => format!("{written}.is_some()); // t is {:?}", t.value()),
            Some((t, condition)) => {
                let (t, bound) = (t.value(), 8.0 * condition * f64::EPSILON * t.value());
                format!("{written}.is_some_and(|hit| (hit.t - {t:?}).abs() <= {bound:.1e}));")
            }
        })
    }

    /// The worst input in words, and as lines of Rust.
    pub fn in_words(&self, whose: &str, worst: &Worst) -> String {
        let line = |(input, is_decision): (&Option<Input>, bool)| {
            let test = self.test(input.as_ref()?, is_decision)?;
            let wrong = if is_decision {
                "it hits or misses wrongly:\n  "
            } else {
                ""
            };
            Some(format!("\n  {wrong}{test}"))
        };
        let lines = [(&worst.input, false), (&worst.wrong, true)].into_iter();
        let lines: String = lines.filter_map(line).collect();
        let (name, error) = (self.name, worst.error);
        format!("{name}, {whose}: off by up to {error:.1e} times condition · ulp{lines}")
    }
}

/// A number of any sign with random digits, and an exponent between two that are greater by 20.
fn bits(numbers: &mut Numbers, [least, most]: [usize; 2]) -> f64 {
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
    let ours = subject.worst(&|x, ray| subject.lesson(x, ray), INPUTS);
    let ours = subject.in_words("the lesson's formula", &ours);
    Ok(format!("{theirs}\n{ours}"))
}
