//! Error against run time for transforms and their inverses.

use std::rc::Rc;

use a02_math::Vector3;
use a03_rays_cameras::PixelRandom;
use common::ArgumentError;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::lab::extremes::matrices::{off_identity, turn};
use crate::lab::protocol::Chained;
use crate::{Mat4x4, Transform};

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![nesting(), condition()]
}

/// A matrix and its inverse by a method, from the steps of a chain.
type Build = fn(&mut dyn Iterator<Item = &Transform>) -> (Mat4x4, Mat4x4);

/// The methods, with the number of products for a step.
const METHODS: [(&str, f64, Build); 3] = [
    // Ours: the inverses of the steps, multiplied in the opposite order.
    ("inverses, opposite order", 2.0, |steps| {
        let one = (Mat4x4::IDENTITY, Mat4x4::IDENTITY);
        steps.fold(one, |(m, i), step| (m * step.matrix(), step.inverse() * i))
    }),
    // By glam: adjugate over determinant.
    ("inverse of the product", 1.0, |steps| {
        let m = steps.fold(Mat4x4::IDENTITY, |m, step| m * step.matrix());
        (m, inverted(m))
    }),
    // The protocol's: the inverses multiplied in the same order.
    ("inverses, same order", 2.0, |steps| {
        let Chained { m, i } = steps.fold(Chained::IDENTITY, Chained::then);
        (m, i)
    }),
];

/// A curve for each of the methods, with its slope and remark.
fn curves(
    curve: impl Fn(&'static str, f64, Build) -> Curve<'static>,
    theory: [(Option<f64>, &'static str); 3],
    between: (f64, f64),
) -> Vec<Curve<'static>> {
    let curves = METHODS.into_iter().zip(theory);
    let curves = curves.map(|((method, products, build), (slope, remark))| {
        let curve = curve(method, products, build);
        curve.with_slope(slope, between).with_remark(remark)
    });
    curves.collect()
}

fn inverted(m: Mat4x4) -> Mat4x4 {
    Mat4x4::from_rows(m.to_glam().inverse().transpose().to_cols_array_2d())
}

/// Uses a result, so that the compiler cannot remove a timed run.
fn trace(m: Mat4x4) -> f64 {
    (m * Vector3::new(1.0, 1.0, 1.0)).x()
}

fn nesting() -> Experiment<'static> {
    Experiment {
        name: "nested-turns",
        about: "How many turns can be nested before the inverse is no inverse?",
        knob: "turns",
        work: "4x4 products",
        error: "rms error of the numbers of M I",
        unit: Unit::Other("identity = 1"),
        exact: "against those of the identity",
        seeds: &[],
        against: Axis::Knob,
        curves: Box::new(|effort| {
            let steps = (0..30).filter_map(|i| turn(Transform::IDENTITY, i).ok());
            let steps: Rc<[Transform]> = steps.collect();
            let counts = &[1e2, 1e3, 1e4, 1e5, 1e6][..effort.choose(4, 5)];
            let curve = |method, products, build: Build| {
                let points = counts.iter().map(|count| {
                    let steps = Rc::clone(&steps);
                    let build = move || build(&mut steps.iter().cycle().take(*count as usize));
                    let (m, i) = build();
                    let run = move || trace(build().1);
                    Point::new(*count, products * count, off_identity(m, i), run)
                });
                Curve::new(method, points)
            };
            let of_product = "not in the renderer: a scene nests a few turns, and where it \
                 stretches this loses twice the digits (see `condition`)";
            let theory = [(Some(1.0), ""), (None, of_product), (None, NO_INVERSE)];
            curves(curve, theory, (1e2, 1e6))
        }),
    }
}

const NO_INVERSE: &str = "the protocol's; no inverse at all";

/// The rotations before and after a scaling.
fn pair_of_turns(n: u32) -> Result<[Transform; 2], ArgumentError> {
    let random = PixelRandom::new(10, n, 0);
    let angle = |i| 6.3 * random.uniform(i);
    let start = Transform::IDENTITY;
    Ok([
        start.rotate_x(angle(0))?.rotate_y(angle(1))?,
        start.rotate_y(angle(2))?.rotate_z(angle(3))?,
    ])
}

fn condition() -> Experiment<'static> {
    Experiment {
        name: "condition",
        about: "What does an uneven stretching by k cost in digits?",
        knob: "stretching k",
        seeds: &[10],
        curves: Box::new(|effort: Effort| {
            let count = effort.choose(4_096, 65_536) as u32;
            let pairs: Rc<[_]> = (0..count).filter_map(|n| pair_of_turns(n).ok()).collect();
            let curve = |method, products, build: Build| {
                let points = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7].map(|k| {
                    let stretch = Transform::IDENTITY.scale(k, 1.0, 1.0);
                    let stretch = stretch.unwrap_or(Transform::IDENTITY);
                    let build = move |[a, b]: &[_; 2]| build(&mut [a, &stretch, b].into_iter());
                    let errors = pairs
                        .iter()
                        .map(build)
                        .flat_map(|(m, i)| off_identity(m, i));
                    let (all, work) = (Rc::clone(&pairs), 3.0 * products * f64::from(count));
                    let run = move || all.iter().map(|pair| trace(build(pair).1)).sum();
                    Point::new(k, work, errors, run)
                });
                Curve::new(method, points)
            };
            let stored = "eps k is what rounding the numbers of an exact inverse costs, too";
            let theory = [
                (Some(1.0), stored),
                (Some(2.0), "eps k²"),
                (None, NO_INVERSE),
            ];
            curves(curve, theory, (1e2, 1e7))
        }),
        ..nesting()
    }
}
