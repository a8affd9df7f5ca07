//! The angle between two vectors, from large to tiny.
//!
//! The inputs are numbers with few binary digits, so that the angle is known exactly and only the method
//! rounds.

use measure::exact::sum_of_products;
use measure::experiment::{Axis, Curve, Experiment, Slope, TaskSet, Unit};

use crate::protocol;
use a02_math::{Direction, Vector3};

/// Kahan's formula, with the vectors scaled to equal length (How Futile are Mindless
/// Assessments of Roundoff, 2006).
fn kahan(a: Vector3, b: Vector3) -> f64 {
    let (a, b) = (a * b.magnitude(), b * a.magnitude());
    2.0 * libm::atan2((a - b).magnitude(), (a + b).magnitude())
}

/// The arc tangent of sine and cosine, with the sine from exact products.
fn exact_products(a: Vector3, b: Vector3) -> f64 {
    let (p, q) = (a.to_glam(), b.to_glam());
    let minor = |x: usize, y: usize| sum_of_products(&[[p[x], q[y]], [-p[y], q[x]]]);
    let cross = Vector3::new(minor(1, 2), minor(2, 0), minor(0, 1));
    libm::atan2(cross.magnitude(), a.dot(b))
}

/// Two vectors and the angle between them.
struct Task {
    a: Vector3,
    b: Vector3,
    exact: f64,
}

/// The second vector is a vector `a` of whole numbers plus a perpendicular vector
/// times a power of two; the quotient of their lengths is the tangent, about
/// 2^-`bits`. The sum fills 52 binary digits and is exact.
fn task(numbers: &mut WholeNumbers, bits: i32) -> Task {
    let digits = (bits - 4).max(5);
    let (across, a) = loop {
        let across = odd_numbers(numbers, 44 - digits);
        let a = across.cross(odd_numbers(numbers, digits));
        if a != Vector3::default() {
            break (across, a);
        }
    };
    let across = across * libm::scalbn(1.0, digits - bits);
    let tangent = (across.dot(across) / a.dot(a)).sqrt();
    Task {
        a,
        b: a + across,
        exact: libm::atan(tangent),
    }
}

fn odd_numbers(numbers: &mut WholeNumbers, digits: i32) -> Vector3 {
    let mut odd = || 2.0 * numbers.signed(digits as u32) + 1.0;
    Vector3::new(odd(), odd(), odd())
}

/// The error as a fraction of the angle. For small angles the arc cosine is 0 or NaN.
fn error(Task { exact, .. }: &Task, angle: f64) -> [f64; 1] {
    let error = (angle - exact) / exact;
    [if angle.is_nan() { 1.0 } else { error }]
}

pub fn angles() -> Experiment<'static> {
    Experiment {
        question: "Which formula sees small angles?",
        parameter: "1 / tangent",
        work: "angles",
        against: Axis::Parameter,
        error: "rms error of the angle",
        unit: Unit::FractionOf("the angle"),
        exact: "against the angle by construction; where there is none, the error is 1",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("angle")
    }
}

const SEED: u64 = 1;

/// The number of pairs of vectors with about the same angle.
const COUNT: usize = 4096;

fn curves() -> Vec<Curve<'static>> {
    let mut sets = Vec::new();
    for bits in (0..=40).step_by(4) {
        let mut numbers = WholeNumbers(SEED);
        sets.push(TaskSet {
            parameter: libm::scalbn(1.0, bits),
            tasks: (0..COUNT).map(|_| task(&mut numbers, bits)).collect(),
        });
    }
    let curve = |method, slope, angle: fn(Vector3, Vector3) -> f64| Curve {
        slope: Some(Slope {
            value: slope,
            between: 10.0..=1e6,
        }),
        ..Curve::of_tasks(method, &sets, move |task| angle(task.a, task.b), error)
    };
    vec![
        curve("arc tangent", 1.0, Vector3::angle),
        curve("arc cosine", 2.0, protocol::angle_by_arc_cosine),
        curve("Kahan's formula", 1.0, kahan),
        curve("exact products", 0.0, exact_products),
    ]
}

/// Random whole numbers, the same in every run, from a linear congruential generator with
/// the multiplier of Knuth's MMIX.
struct WholeNumbers(u64);

impl WholeNumbers {
    /// A number between -2^bits and 2^bits, both excluded.
    fn signed(&mut self, bits: u32) -> f64 {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        const INCREMENT: u64 = 1_442_695_040_888_963_407;
        self.0 = self.0.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        // The high bits are the random ones.
        let number = (self.0 >> (63 - bits)) as i64 - (1 << bits);
        number.max(1 - (1 << bits)) as f64
    }
}
