//! Vectors that were halved many times, brought to length 1.

use std::rc::Rc;

use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use super::WholeNumbers;
use crate::Vector3;
use crate::lab::{extremes::vector, protocol};

/// Normalisation that always scales, without the short cut for usual lengths.
fn always_scaled(v: Vector3) -> Vector3 {
    let largest = v.to_glam().abs().max_element();
    let scaled = v.to_glam().map(|x| libm::scalbn(x, -libm::ilogb(largest)));
    Vector3::from_glam(scaled / scaled.length())
}

const WHY_NOT: &str = "not in the renderer: the same digits at a higher price for usual lengths";

pub fn experiment() -> Experiment<'static> {
    let curves = |effort| {
        let halvings = [1, 10, 100, 500, 510, 520, 530, 540, 600, 1000];
        let sets = halvings.map(|halvings| (halvings.into(), tasks(halvings, effort)));
        let curve = |method, normalized: fn(Vector3) -> Vector3| {
            let error = |(_, exact): &Task, direction: Vector3| {
                let error = (direction - *exact).to_glam().to_array();
                error.map(|error| if error.is_finite() { error } else { 1.0 })
            };
            Curve::of_tasks(method, &sets, move |(v, _)| normalized(*v), error)
        };
        // A rounded square, root and quotient.
        let bound = 2.0 * f64::EPSILON;
        vec![
            curve("ours", |v| v.normalized().unwrap_or_default()).with_bound(bound, 0.0..=1e9),
            curve("divided by its length", protocol::normalized).with_bound(bound, 0.0..=500.0),
            curve("always scaled", always_scaled).with_remark(WHY_NOT),
        ]
    };
    Experiment {
        name: "normalise",
        about: "How short may a vector be?",
        knob: "halvings of the vector",
        work: "vectors",
        error: "rms error of a coordinate of the direction",
        unit: Unit::Other("length = 1"),
        exact: "against a quotient of whole numbers; where there is no direction, the error is 1",
        seeds: &[2],
        against: Axis::Knob,
        curves: Box::new(curves),
    }
}

/// Whole numbers whose squares add up to a square: x, y, z and the root.
const WHOLE: [[f64; 4]; 6] = [
    [1.0, 2.0, 2.0, 3.0],
    [2.0, 3.0, 6.0, 7.0],
    [1.0, 4.0, 8.0, 9.0],
    [4.0, 4.0, 7.0, 9.0],
    [2.0, 6.0, 9.0, 11.0],
    [6.0, 6.0, 7.0, 11.0],
];

/// A vector and its exact direction.
type Task = (Vector3, Vector3);

fn tasks(halvings: i32, effort: Effort) -> Rc<[Task]> {
    let mut numbers = WholeNumbers(2);
    let mut task = || {
        let [x, y, z, length] = WHOLE[numbers.signed(20).abs() as usize % WHOLE.len()];
        let numbers = [x, y, z].map(|x: f64| x.copysign(numbers.signed(1) - 0.5));
        let halved = numbers.map(|x| libm::scalbn(x, -halvings));
        (vector(halved), vector(numbers.map(|x| x / length)))
    };
    (0..effort.choose(4096, 65_536)).map(|_| task()).collect()
}
