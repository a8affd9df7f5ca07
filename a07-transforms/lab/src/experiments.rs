//! Error against run time for transforms and their inverses.

pub mod nested_nodes;

use std::rc::Rc;

use a03_rays_cameras::PixelRandom;
use common::ArgumentError;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Point, Unit};

use crate::extremes::matrices::{off_identity, turn};
use crate::protocol::Chained;
use a07_transforms::{Mat4x4, Transform};

pub fn experiments() -> Vec<Experiment<'static>> {
    let mut all = vec![nesting(), condition()];
    all.extend(nested_nodes::experiments());
    all
}

/// A matrix and its inverse by a method, from the steps of a chain.
type Build = fn(&mut dyn Iterator<Item = &Transform>) -> (Mat4x4, Mat4x4);

/// A method's name and its number of products for a step.
type Method = (&'static str, f64, Build);

const METHODS: [Method; 3] = [
    // Ours: the inverses of the steps, multiplied in the opposite order.
    ("inverses, opposite order", 2.0, |steps| {
        let one = (Mat4x4::IDENTITY, Mat4x4::IDENTITY);
        steps.fold(one, |(m, i), step| (m * step.matrix(), step.inverse() * i))
    }),
    // By glam: adjugate over determinant.
    ("inverse of the product", 1.0, |steps| {
        let m = steps.fold(Mat4x4::IDENTITY, |m, step| m * step.matrix());
        let inverse = m.to_glam().inverse().transpose();
        (m, Mat4x4::from_rows(inverse.to_cols_array_2d()))
    }),
    // The protocol's: the inverses multiplied in the same order.
    ("inverses, same order", 2.0, |steps| {
        let Chained { m, i } = steps.fold(Chained::IDENTITY, Chained::then);
        (m, i)
    }),
];

fn nesting() -> Experiment<'static> {
    Experiment::new("nested-turns")
        .asking("How many turns can be nested before the inverse is no inverse?")
        .over(Axis::Parameter, "turns", "4x4 products")
        .with_error("rms error of the numbers of M I")
        .with_unit(Unit::Other("identity = 1"))
        .with_exact("against those of the identity")
        .with_curves(|effort| {
            let steps = (0..30).filter_map(|i| turn(Transform::IDENTITY, i).ok());
            let steps: Rc<[Transform]> = steps.collect();
            let counts = &[1e2, 1e3, 1e4, 1e5, 1e6][..effort.choose(4, 5)];
            let curve = |(method, products, build): Method| {
                let points = counts.iter().map(|count| {
                    let steps = Rc::clone(&steps);
                    let build = move || build(&mut steps.iter().cycle().take(*count as usize));
                    let (m, i) = build();
                    let errors = off_identity(m, i).map(|error| Deviation::new(error, 1.0, 1.0));
                    Point::new(*count, products * count, errors, build)
                });
                Curve::new(method, points)
            };
            let [ours, of_product, same_order] = METHODS.map(curve);
            vec![ours.with_slope(1.0, (1e2, 1e6)), of_product, same_order]
        })
}

/// The rotations before and after a scaling.
fn pair_of_turns(n: u32) -> Result<[Transform; 2], ArgumentError> {
    let random = PixelRandom::new(10, n, 0);
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| 6.3 * random.uniform(i));
    let before = Transform::IDENTITY.rotate_x(a)?.rotate_y(b)?;
    Ok([before, Transform::IDENTITY.rotate_y(c)?.rotate_z(d)?])
}

fn condition() -> Experiment<'static> {
    Experiment::new("condition")
        .asking("What does an uneven stretching by k cost in digits?")
        .over(Axis::Parameter, "stretching k", "4x4 products")
        .with_error("rms error of the numbers of M I")
        .with_unit(Unit::Other("identity = 1"))
        .with_exact("against those of the identity")
        .with_seeds(&[10])
        .with_curves(|effort| {
            let count = effort.choose(4_096, 65_536) as u32;
            let pairs: Rc<[_]> = (0..count).filter_map(|n| pair_of_turns(n).ok()).collect();
            let curve = |(method, products, build): Method| {
                let points = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7].map(|k| {
                    let stretch = Transform::IDENTITY.scale(k, 1.0, 1.0);
                    let stretch = stretch.unwrap_or(Transform::IDENTITY);
                    let build = move |[a, b]: &[_; 2]| build(&mut [a, &stretch, b].into_iter());
                    let built = pairs.iter().map(&build);
                    let errors = built.flat_map(|(m, i)| off_identity(m, i));
                    let errors = errors.map(|error| Deviation::new(error, 1.0, k));
                    let (all, work) = (Rc::clone(&pairs), 3.0 * products * f64::from(count));
                    let run = move || {
                        let built = all.iter().map(&build);
                        built.map(|(m, _)| m.rows()[0][0]).sum::<f64>()
                    };
                    Point::new(k, work, errors.collect::<Vec<_>>(), run)
                });
                Curve::new(method, points)
            };
            let [ours, of_product, same_order] = METHODS.map(curve);
            vec![
                ours.with_slope(1.0, (1e2, 1e7)),
                of_product.with_slope(2.0, (1e2, 1e7)),
                same_order,
            ]
        })
}
