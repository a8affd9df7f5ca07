//! Wrong decisions of rays that leave shapes under nested nodes, by the condition of the nodes.

use std::f64::consts::TAU;
use std::rc::Rc;

use a02_math::{Normal3, Point3, Vector3};
use a04_intersections::lab::support::{Numbers, Triple, point};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use a06_shadows_reflection::lab::experiments::secondary_rays::{Sets, acne, leaks, points};
use a06_shadows_reflection::lab::lit_points::{Look, SEED, Shape, trials, world};
use common::Error;
use measure::Effort;
use measure::experiment::Experiment;

use crate::{Disc, Node, Transform};

pub fn experiments() -> Vec<Experiment<'static>> {
    let condition = "longest / shortest axis";
    let asked = "Which rays keep a shape under nested nodes out of its own shadow?";
    let found = "Which rays find an object near a shape under nested nodes?";
    vec![
        acne("acne-under-a-node", asked).over("scene size (units)", by_size),
        acne("acne-under-nodes", asked).over(condition, by_condition),
        leaks("leaks-under-nodes", found).over(condition, by_condition),
    ]
}

fn by_size(effort: Effort) -> Sets {
    let aim = (MIDDLE, [9.0, 0.3]);
    let set = |size| (size, points(&SHAPES, [size; 2], aim, effort));
    [1e-6, 1.0, 1e4, 1e9].map(set).into()
}

fn by_condition(effort: Effort) -> Sets {
    let count = effort.choose(4_096, 65_536);
    let set = |condition| {
        let points = trials(count, SEED, 1.0, |numbers| look(numbers, condition));
        (condition, points.unwrap_or_default().into())
    };
    [1.0, 1e3, 1e5, 1e7, 1e9].map(set).into()
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
    Ok((Rc::new(world(shape)?), [eye, target]))
}

/// Shapes under transforms, which no ray may hit again that leaves them.
#[rustfmt::skip]
const SHAPES: [Shape; 6] = [
    |size| transformed(size, Sphere::new(Point3::ORIGIN, 1.0)?),
    |size| transformed(size, Plane::new(Point3::ORIGIN, SLANTED)?),
    |size| transformed(size, AxisAlignedBox::new(point([-0.3, -0.4, -0.1]), point([0.3, 0.2, 0.5]))?),
    |size| {
        let [a, b, c] = [[-1.1, -0.2, -0.9], [1.3, 0.1, -0.7], [0.2, 0.3, 1.7]].map(point);
        transformed(size, Triangle::new(a, b, c)?)
    },
    |size| transformed(size, Disc::new(point([0.0, 0.1, 0.0]), SLANTED, 1.5)?),
    needle,
];

/// A disc that stands on its thin side: along its normal, nothing is flattened, but the numbers
/// between both nodes are a thousand times as large as those of the scene.
fn needle(size: f64) -> Result<World<()>, Error> {
    let turn = Transform::IDENTITY.rotate_z(0.6)?;
    let along_x = turn.inverse() * Vector3::new(1.0, 0.0, 0.0);
    let disc = Disc::new(Point3::ORIGIN, along_x.as_normal(), size)?;
    let flat = Transform::IDENTITY.translate(point(MIDDLE.map(|x| x * size)))?;
    world(Node::new(flat.scale(1.0, 1e-3, 1.0)?).with(Node::new(turn).with(disc)))
}

const SLANTED: Normal3 = Normal3::new(0.3, 1.0, 0.2);

/// Where the transforms move the origin, in sizes of the scene.
const MIDDLE: Triple = [0.3, -0.2, 0.7];

fn transformed(size: f64, shape: impl Geometry) -> Result<World<()>, Error> {
    let transform = Transform::IDENTITY
        .translate(point(MIDDLE.map(|x| x * size)))?
        .rotate_x(0.4)?
        .rotate_y(1.1)?
        .scale(size, 0.5 * size, 2.0 * size)?;
    world(Node::new(transform).with(shape))
}
