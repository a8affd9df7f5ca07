//! Wrong decisions of rays that leave shapes under nested nodes, by the condition of the nodes.

use std::f64::consts::TAU;

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Sphere};
use a04_lab::support::Numbers;
use a06_lab::experiments::secondary_rays::{FOR_EVERY_SHAPE, Sets, Wrong, acne, leaks};
use a06_lab::lit_points::{Look, SEED, Trial, trials};
use a06_lab::surface::surface;
use common::Error;
use measure::Effort;
use measure::experiment::Experiment;

use a07_transforms::{Disc, Node, Transform};

pub fn experiments() -> Vec<Experiment<'static>> {
    let condition = "longest / shortest axis";
    let asked = "Which rays keep a shape under nested nodes out of its own shadow?";
    let found = "Which rays find an object near a shape under nested nodes?";
    vec![
        Wrong {
            policies: &FOR_EVERY_SHAPE,
            ..acne("acne-under-nodes", asked)
        }
        .over(condition, by_condition),
        Wrong {
            policies: &FOR_EVERY_SHAPE,
            ..leaks("leaks-under-nodes", found)
        }
        .over(condition, by_condition),
    ]
}

fn by_condition(effort: Effort) -> Sets {
    let count = effort.choose(4_096, 65_536);
    let set = |condition| {
        let points = lit_points(count, SEED, condition);
        (condition, points.unwrap_or_default().into())
    };
    [1.0, 1e3, 1e5, 1e7, 1e9].map(set).into()
}

/// Lit points of shapes under nodes of this condition.
pub fn lit_points(count: usize, seed: u64, condition: f64) -> Result<Vec<Trial>, Error> {
    trials(count, seed, 1.0, |numbers| look(numbers, condition))
}

/// A look at a box, ball or disc under one to three nodes, each of which translates, flattens
/// and, one time in two each, turns before and after.
fn look(numbers: &mut Numbers, condition: f64) -> Result<Look, Error> {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let mut shape: Box<dyn Geometry> = match numbers.below(3) {
        0 => Box::new(AxisAlignedBox::new(
            Point3::new(-1.0, -1.0, -1.0),
            Point3::new(1.0, 1.0, 1.0),
        )?),
        1 => Box::new(Sphere::new(Point3::ORIGIN, 1.0)?),
        _ => Box::new(Disc::new(Point3::ORIGIN, up, 1.0)?),
    };
    let mut target = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let levels = 1 + numbers.below(3);
    let flat = libm::pow(condition, -1.0 / levels as f64);
    for _ in 0..levels {
        let mut node = Transform::IDENTITY.translate(Point3::ORIGIN + numbers.triple(-1.0, 1.0))?;
        let mut turn = || numbers.below(2) as f64 * numbers.between(0.0, TAU);
        let [a, b, c] = [turn(), turn(), turn()];
        let mut scale = [1.0, libm::pow(flat, numbers.between(0.0, 1.0)), flat];
        scale.rotate_left(numbers.below(3));
        let [x, y, z] = scale;
        node = node.rotate_x(a)?.rotate_y(b)?.scale(x, y, z)?.rotate_z(c)?;
        target = node.matrix() * target;
        shape = Box::new(Node::new(node).with(shape));
    }
    // Farther away than the three nodes reach.
    let eye = Point3::ORIGIN + numbers.direction() * 9.0;
    Ok((surface(shape)?, [eye, target]))
}
