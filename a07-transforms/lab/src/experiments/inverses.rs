//! Methods for the inverse of a chain of transforms, one of which stretches.

use std::rc::Rc;

use a03_rays_cameras::PixelRandom;
use common::ArgumentError;
use measure::experiment::{Axis, Curve, Errors, Experiment, Point, Slope, Times, Unit};

use crate::extremes::matrices::off_identity;
use crate::protocol::Chained;
use a07_transforms::{Mat4x4, Transform};

/// A method for a matrix and its inverse, from the steps of a chain.
struct Method {
    name: &'static str,
    /// The number of products of two matrices for each step.
    products: f64,
    build: fn([&Transform; 3]) -> Chained,
}

/// The inverses of the steps, multiplied in the opposite order.
const OURS: Method = Method {
    name: "inverses, opposite order",
    products: 2.0,
    build: |steps| {
        let mut built = Chained::IDENTITY;
        for step in steps {
            built.m = built.m * step.matrix();
            built.i = step.inverse() * built.i;
        }
        built
    },
};

/// By glam: adjugate over determinant.
const OF_THE_PRODUCT: Method = Method {
    name: "inverse of the product",
    products: 1.0,
    build: |steps| {
        let mut m = Mat4x4::IDENTITY;
        for step in steps {
            m = m * step.matrix();
        }
        let inverse = m.to_glam().inverse().transpose();
        let i = Mat4x4::from_rows(inverse.to_cols_array_2d());
        Chained { m, i }
    },
};

/// The protocol's: the inverses multiplied in the same order.
const SAME_ORDER: Method = Method {
    name: "inverses, same order",
    products: 2.0,
    build: |steps| {
        let mut built = Chained::IDENTITY;
        for step in steps {
            built = built.then(step);
        }
        built
    },
};

pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "What does an uneven stretching by k cost in digits?",
        parameter: "stretching k",
        seeds: &[SEED],
        work: "4x4 products",
        against: Axis::Parameter,
        error: "rms error of the numbers of M I",
        unit: Unit::Other("identity = 1"),
        exact: "against those of the identity",
        curves: Box::new(curves),
        ..Experiment::new("condition")
    }
}

const SEED: u64 = 10;

/// The number of chains that each factor stretches.
const COUNT: u32 = 4_096;

fn curves() -> Vec<Curve<'static>> {
    let turns: Vec<Turns> = (0..COUNT).filter_map(|n| Turns::random(n).ok()).collect();
    let turns: Rc<[Turns]> = turns.into();
    let curve = |method: &Method| {
        let factors = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7];
        Curve::new(method.name, factors.map(|k| stretched(method, &turns, k)))
    };
    let slope = |value| {
        let between = 1e2..=1e7;
        Some(Slope { value, between })
    };
    vec![
        Curve {
            slope: slope(1.0),
            ..curve(&OURS)
        },
        Curve {
            slope: slope(2.0),
            ..curve(&OF_THE_PRODUCT)
        },
        curve(&SAME_ORDER),
    ]
}

/// The rotations before and after a scaling.
struct Turns {
    before: Transform,
    after: Transform,
}

impl Turns {
    fn random(n: u32) -> Result<Self, ArgumentError> {
        let random = PixelRandom::new(SEED, n, 0);
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| 6.3 * random.uniform(i));
        Ok(Self {
            before: Transform::IDENTITY.rotate_x(a)?.rotate_y(b)?,
            after: Transform::IDENTITY.rotate_y(c)?.rotate_z(d)?,
        })
    }
}

/// The measurement of scalings of one axis by `k` between rotations.
fn stretched(method: &Method, turns: &Rc<[Turns]>, k: f64) -> Point<'static> {
    let stretch = Transform::IDENTITY.scale(k, 1.0, 1.0);
    let stretch = stretch.unwrap_or(Transform::IDENTITY);
    let build = method.build;
    let build = move |turns: &Turns| {
        let steps = [&turns.before, &stretch, &turns.after];
        build(steps)
    };
    let mut errors = Vec::new();
    for turns in turns.iter() {
        let built = build(turns);
        errors.extend(off_identity(built.m, built.i));
    }
    let run = Rc::clone(turns);
    Point {
        parameter: k,
        work: 3.0 * method.products * turns.len() as f64,
        errors: Errors::of(errors),
        times: Times::of(move || {
            let matrices = run.iter().map(|turns| build(turns).m);
            matrices.map(|m| m.rows()[0][0]).sum::<f64>()
        }),
    }
}
