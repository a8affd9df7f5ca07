//! The angle between two vectors, from large to tiny.

use std::rc::Rc;

use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use super::WholeNumbers;
use crate::lab::exact::sum_of_products;
use crate::lab::protocol;
use crate::{Direction, Vector3};

type Method = fn(Vector3, Vector3) -> f64;

/// Kahan's formula, with the vectors scaled to equal length (How Futile are Mindless
/// Assessments of Roundoff, 2006).
fn kahan(a: Vector3, b: Vector3) -> f64 {
    let (scaled_a, scaled_b) = (a * b.magnitude(), b * a.magnitude());
    2.0 * libm::atan2(
        (scaled_a - scaled_b).magnitude(),
        (scaled_a + scaled_b).magnitude(),
    )
}

/// The arc tangent of sine and cosine, with the sine from exact products.
fn exact_products(a: Vector3, b: Vector3) -> f64 {
    let minor = |p: f64, q: f64, r: f64, s: f64| sum_of_products(&[(p, q), (-r, s)]);
    let cross = Vector3::new(
        minor(a.y(), b.z(), a.z(), b.y()),
        minor(a.z(), b.x(), a.x(), b.z()),
        minor(a.x(), b.y(), a.y(), b.x()),
    );
    libm::atan2(cross.magnitude(), a.dot(b))
}

const WHY_NOT: &str = "does not scale long and short vectors as ours does; \
     not in the renderer: no picture shows an angle's last digits";

pub fn experiment() -> Experiment<'static> {
    let curves = |effort| {
        let steps = [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40];
        let sets = steps.map(|bits| (libm::scalbn(1.0, bits), tasks(bits, effort)));
        let curve = |method, slope: f64, angle: Method| {
            // For smaller angles the arc cosine is 0 or NaN.
            let error = |(.., exact): &Task, angle: f64| {
                let error = angle / exact - 1.0;
                [if error.is_nan() { 1.0 } else { error }]
            };
            let curve = Curve::of_tasks(method, &sets, move |(a, b, _)| angle(*a, *b), error);
            curve.with_slope(slope, (10.0, 1e6))
        };
        vec![
            curve("arc tangent", 1.0, Vector3::angle),
            curve("arc cosine", 2.0, protocol::angle_by_arc_cosine),
            curve("Kahan's formula", 1.0, kahan),
            curve("exact products", 0.0, exact_products).with_remark(WHY_NOT),
        ]
    };
    Experiment {
        name: "angle",
        about: "Which formula sees small angles?",
        knob: "1 / tangent",
        work: "angles",
        error: "rms error of the angle",
        unit: Unit::Other("share of the angle"),
        exact: "against the angle by construction; where there is none, the error is 1",
        seeds: &[1],
        against: Axis::Knob,
        curves: Box::new(curves),
    }
}

/// Two vectors and the angle between them.
type Task = (Vector3, Vector3, f64);

/// The second vector is a vector `a` of whole numbers plus a perpendicular vector
/// times a power of two; the quotient of their lengths is the tangent, about
/// 2^-`bits`. The sum fills 52 binary digits and is exact.
fn tasks(bits: i32, effort: Effort) -> Rc<[Task]> {
    let mut numbers = WholeNumbers(1);
    let digits = (bits - 4).max(5);
    let mut task = || {
        let mut vector = |digits: i32| {
            let mut odd = || 2.0 * numbers.signed(digits as u32) + 1.0;
            Vector3::new(odd(), odd(), odd())
        };
        let (across, a) = loop {
            let across = vector(44 - digits);
            let a = across.cross(vector(digits));
            if a != Vector3::default() {
                break (across, a);
            }
        };
        let across = across * libm::scalbn(1.0, digits - bits);
        let tangent = (across.dot(across) / a.dot(a)).sqrt();
        (a, a + across, libm::atan(tangent))
    };
    (0..effort.choose(4096, 65_536)).map(|_| task()).collect()
}
