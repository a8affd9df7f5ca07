//! Conditions: by how many units in its last place a result changes, if each given number changes by one.
//!
//! Each number is changed by a tiny fraction of itself, and the result is computed with 30 digits.

use crate::exact::DoubleDouble;

/// Three numbers with 30 digits.
pub type Exact3 = [DoubleDouble; 3];

/// The fraction of itself by which a number is changed. The result moves by as many of its 31 digits as are
/// left after 15 and the condition.
const STEP: f64 = f64::EPSILON;

/// The sum of `|∂f/∂x · x|` over all given numbers x, of the result f that changes most, over the
/// greatest result.
pub fn condition<const N: usize>(
    numbers: &[f64],
    results: impl Fn(&[DoubleDouble]) -> [DoubleDouble; N],
) -> f64 {
    let numbers: Vec<_> = numbers.iter().map(|x| DoubleDouble::from(*x)).collect();
    let unchanged = results(&numbers);
    let mut moved = [0.0; N];
    for index in 0..numbers.len() {
        let mut changed = numbers.clone();
        changed[index] = changed[index] * (1.0 + STEP).into();
        for (i, result) in results(&changed).into_iter().enumerate() {
            moved[i] += (result - unchanged[i]).value().abs();
        }
    }
    let greatest = |numbers: [f64; N]| numbers.map(f64::abs).into_iter().fold(0.0, f64::max);
    greatest(moved) / (STEP * greatest(unchanged.map(DoubleDouble::value)))
}

/// The condition of the angle between two vectors that are not parallel.
///
/// A change turns the pair of sine and cosine by the change of the angle.
pub fn condition_of_angle(a: [f64; 3], b: [f64; 3], angle: f64) -> f64 {
    let numbers = [a, b].concat();
    let sine_and_cosine = |x: &[DoubleDouble]| {
        let (a, b) = (three(x, 0), three(x, 3));
        let across = cross(a, b);
        [dot(across, across).sqrt(), dot(a, b)]
    };
    let unchanged: Vec<_> = numbers.iter().map(|x| DoubleDouble::from(*x)).collect();
    let [sine, cosine] = sine_and_cosine(&unchanged);
    let turned = condition(&numbers, |x| {
        let [s, c] = sine_and_cosine(x);
        // The tangent of the change, next to 1: only the change counts.
        let turn = (s * cosine - c * sine) / (s * sine + c * cosine);
        [turn + 1.0.into()]
    });
    turned / angle
}

/// Three of these numbers, from an index on.
pub fn three(numbers: &[DoubleDouble], from: usize) -> Exact3 {
    [numbers[from], numbers[from + 1], numbers[from + 2]]
}

pub fn dot(a: Exact3, b: Exact3) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Exact3, b: Exact3) -> Exact3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The vector in this direction of length 1.
pub fn unit(a: Exact3) -> Exact3 {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}
