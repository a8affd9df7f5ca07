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

/// All experiments of the stage.
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![nesting(), condition()]
}

/// Methods for the inverse of a product of steps.
#[derive(Clone, Copy)]
enum Inverse {
    /// Our method: the inverses of the steps, multiplied in the opposite order.
    Stored,
    /// The inverse of the finished product, by glam: adjugate over determinant.
    OfProduct,
    /// The protocol's method: the inverses multiplied in the same order.
    SameOrder,
}

impl Inverse {
    const fn method(self) -> &'static str {
        match self {
            Self::Stored => "inverses, opposite order",
            Self::OfProduct => "inverse of the product",
            Self::SameOrder => "inverses, same order",
        }
    }

    fn build<'s>(self, steps: impl Iterator<Item = &'s Transform>) -> (Mat4x4, Mat4x4) {
        let one = Mat4x4::IDENTITY;
        match self {
            Self::Stored => steps.fold((one, one), |(m, i), step| {
                (m * step.matrix(), step.inverse() * i)
            }),
            Self::OfProduct => {
                let m = steps.fold(one, |m, step| m * step.matrix());
                (m, inverted(m))
            }
            Self::SameOrder => {
                let Chained { m, i } = steps.fold(Chained::IDENTITY, Chained::then);
                (m, i)
            }
        }
    }
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
            let curve = |inverse: Inverse, products: f64| {
                let points = counts.iter().map(|count| {
                    let steps = Rc::clone(&steps);
                    let build = move || inverse.build(steps.iter().cycle().take(*count as usize));
                    let (m, i) = build();
                    Point::new(*count, products * count, off_identity(m, i), move || {
                        trace(build().1)
                    })
                });
                Curve::new(inverse.method(), points)
            };
            vec![
                curve(Inverse::Stored, 2.0).with_slope(1.0, (1e2, 1e6)),
                curve(Inverse::OfProduct, 1.0).with_remark(
                    "not in the renderer: a scene nests a few turns, and where it stretches \
                     this loses twice the digits (see `condition`)",
                ),
                curve(Inverse::SameOrder, 2.0).with_remark(NO_INVERSE),
            ]
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
            let curve = |inverse: Inverse, products: f64| {
                let points = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7].map(|k| {
                    let stretch = Transform::IDENTITY.scale(k, 1.0, 1.0);
                    let stretch = stretch.unwrap_or(Transform::IDENTITY);
                    let build =
                        move |[a, b]: &[Transform; 2]| inverse.build([a, &stretch, b].into_iter());
                    let errors = |pair: &_| {
                        let (m, i) = build(pair);
                        off_identity(m, i)
                    };
                    let mut point =
                        Point::of_all(k, &pairs, errors, move |pair| trace(build(pair).1));
                    point.work *= products;
                    point
                });
                Curve::new(inverse.method(), points)
            };
            let between = (1e2, 1e7);
            vec![
                curve(Inverse::Stored, 6.0)
                    .with_slope(1.0, between)
                    .with_remark(
                        "eps k is what rounding the numbers of an exact inverse costs, too",
                    ),
                curve(Inverse::OfProduct, 3.0)
                    .with_slope(2.0, between)
                    .with_remark("eps k²"),
                curve(Inverse::SameOrder, 6.0).with_remark(NO_INVERSE),
            ]
        }),
        ..nesting()
    }
}
