//! Questions with their exact answers, conditions and margins.

use std::cmp::Ordering;

use corpus::{Answer, Case, Distance, Expected, Hit, Question, Row, Shape, Step};
use num_traits::Zero;

use crate::exact::{cross, difference, digits, dot, double, exact, power_of_two, root};
use crate::question::{Change, conditions, problem};
use crate::solve::Solution;

/// Answers a question.
pub fn answer(question: Question) -> Case {
    let (unchanged, _) = problem(&question, &Change::None);
    let solution = unchanged.solve();
    let (mut condition, mut with_zeros) = (0.0_f64, 0.0_f64);
    let answer = match &solution {
        Solution::Miss => Answer::Miss,
        Solution::Coplanar => Answer::Coplanar,
        Solution::Hit { t, normal, parts } => {
            for part in parts {
                let of_part = conditions(&question, *part);
                condition = condition.max(of_part.relative);
                with_zeros = with_zeros.max(of_part.with_zeros);
            }
            let digits_of_t = digits(|bits| t.approximate(bits));
            let normal = normal.as_ref().map(|normal| {
                let unit = |i: usize| {
                    move |bits: u32| {
                        let normal = normal.clone().map(|x| x.approximate(bits));
                        let length = root(&dot(&normal, &normal), bits);
                        &normal[i] / length
                    }
                };
                [0, 1, 2].map(|i| digits(unit(i)))
            });
            Answer::Hit(Hit {
                t: digits_of_t.parse().unwrap_or(f64::NAN),
                digits: digits_of_t,
                normal,
            })
        }
    };
    let margin = margin(&question, &solution, with_zeros);
    Case {
        question,
        answer,
        condition: short(condition),
        margin,
    }
}

/// Answers a row of a laboratory. Its numbers may be no shape or no ray.
pub fn row(question: Question, expected: Expected) -> Row {
    if validate(&question).is_err() {
        let case = Case {
            question,
            answer: Answer::NoShape,
            condition: 0.0,
            margin: 0.0,
        };
        return Row {
            case,
            distance: None,
            expected,
        };
    }
    let case = answer(question);
    Row {
        distance: distance(&case.question),
        case,
        expected,
    }
}

/// `t` times the length of the direction, of a hit.
fn distance(question: &Question) -> Option<Distance> {
    let (unchanged, _) = problem(question, &Change::None);
    let Solution::Hit { t, .. } = unchanged.solve() else {
        return None;
    };
    let direction = question.direction.map(exact);
    let squared = dot(&direction, &direction);
    let digits = digits(|bits| t.approximate(bits) * root(&squared, bits));
    Some(Distance {
        value: digits.parse().unwrap_or(f64::NAN),
        digits,
    })
}

/// How many patterns of signs are tried for each size of a change.
const PATTERNS: u64 = 12;

/// The greatest change of all numbers at which no trial, nor one of a lesser change, makes the answer
/// jump.
///
/// 0 if the answer were another one for a closed interval: a `t` is at its end.
fn margin(question: &Question, solution: &Solution, condition: f64) -> f64 {
    let (mut closed, _) = problem(question, &Change::None);
    closed.is_closed = true;
    if jumps(solution, &closed.solve(), 0.0) {
        return 0.0;
    }
    let mut margin = 0.0;
    for power in (-60..=-4).step_by(4) {
        let fraction = power_of_two(power);
        let size = double(&fraction);
        for pattern in 0..PATTERNS {
            let change = Change::All {
                fraction: fraction.clone(),
                pattern,
            };
            let (changed, _) = problem(question, &change);
            if jumps(solution, &changed.solve(), condition * size) {
                return margin;
            }
        }
        margin = size;
    }
    margin
}

/// Whether a changed answer is another one, and not the same moved by as much as a relative change of `t`
/// allows.
fn jumps(one: &Solution, other: &Solution, relative: f64) -> bool {
    match (one, other) {
        (Solution::Miss, Solution::Miss) | (Solution::Coplanar, Solution::Coplanar) => false,
        (Solution::Hit { t: one, .. }, Solution::Hit { t: other, .. }) => {
            let [one, other] = [one, other].map(|t| double(&t.approximate(64)));
            // Beside the tangent t moves more than the condition says, at most by about twice.
            let allowed = 4.0 * relative + 4.0 * f64::EPSILON;
            (one - other).abs() > allowed * one.abs()
        }
        _ => true,
    }
}

/// Three significant digits: a condition needs no more.
fn short(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}

/// The question with each number rounded to single precision, or none if there is no such shape or ray.
pub fn single(question: &Question) -> Option<Question> {
    let mut is_normal = true;
    let mut rounded = |number: f64| {
        let single = number as f32;
        is_normal &= single.is_normal() || (number == 0.0);
        f64::from(single)
    };
    let mut single = question.clone();
    for number in single.numbers_mut() {
        *number = rounded(*number);
    }
    for end in &mut single.within {
        if end.is_finite() {
            *end = rounded(*end);
        }
    }
    (is_normal && stands(&single)).then_some(single)
}

/// Refuses numbers that are not finite, and shapes and rays that are none.
pub fn validate(question: &Question) -> Result<(), String> {
    if question.numbers().iter().any(|number| !number.is_finite()) {
        return Err("each number must be finite".to_owned());
    }
    let [min, max] = question.within;
    if min.partial_cmp(&max) != Some(Ordering::Less) {
        return Err("within must be an interval from a number to a greater one".to_owned());
    }
    if question.direction == [0.0; 3] {
        return Err("the direction must not be 0".to_owned());
    }
    if !stands(question) {
        return Err("a shape must have a size, a normal a length, a scale no 0".to_owned());
    }
    Ok(())
}

/// Whether the shape has a size and each triangle an area, and no normal and no factor is 0.
fn stands(question: &Question) -> bool {
    let has_length = |vector: &[f64; 3]| *vector != [0.0; 3];
    let is_shape = match &question.shape {
        Shape::Plane { normal, .. } => has_length(normal),
        Shape::Sphere { radius, .. } => *radius > 0.0,
        Shape::Box { low, high } => (0..3).all(|axis| low[axis] <= high[axis]),
        Shape::Disc { normal, radius, .. } => has_length(normal) && *radius > 0.0,
        Shape::Tube { from, to, radius } => from != to && *radius > 0.0,
        Shape::Triangles(triangles) => triangles.iter().all(|corners| {
            let [a, b, c] = corners.map(|corner| corner.map(exact));
            let normal = cross(&difference(&b, &a), &difference(&c, &a));
            normal.iter().any(|x| !x.is_zero())
        }),
    };
    let is_invertible = question.under.iter().all(|step| match step {
        Step::Translate(_) => true,
        Step::Scale(by) => by.iter().all(|factor| *factor != 0.0),
    });
    is_shape && is_invertible && has_length(&question.direction)
}
