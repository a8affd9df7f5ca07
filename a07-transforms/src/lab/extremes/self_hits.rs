//! Rays that leave the shape that they have hit, under transforms of every size: no
//! ray may hit it again, and no ray may miss an object close to it.

use std::rc::Rc;

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use a06_shadows_reflection::lab::extremes::self_hits::{Trials, row, seen, world};
use common::Error;
use measure::Effort;
use measure::extremes::Case;

use crate::{Disc, Node, Transform};

type Shape = fn(Node) -> Result<Node, Error>;

const SHAPES: [(&str, [&str; 4], Shape); 5] = [
    ("a sphere", ["S61", "S62", "S63", "S64"], |node| {
        Ok(node.with(Sphere::new(Point3::ORIGIN, 1.0)?))
    }),
    ("a plane", ["S65", "S66", "S67", "S68"], |node| {
        Ok(node.with(Plane::new(Point3::ORIGIN, Normal3::new(0.3, 1.0, 0.2))?))
    }),
    ("a box", ["S69", "S70", "S71", "S72"], |node| {
        let (lbf, run) = (Point3::new(-0.3, -0.4, -0.1), Point3::new(0.3, 0.2, 0.5));
        Ok(node.with(AxisAlignedBox::new(lbf, run)?))
    }),
    ("a triangle", ["S73", "S74", "S75", "S76"], |node| {
        let (a, b) = (Point3::new(-1.1, -0.2, -0.9), Point3::new(1.3, 0.1, -0.7));
        Ok(node.with(Triangle::new(a, b, Point3::new(0.2, 0.3, 1.7))?))
    }),
    ("a disc", ["S77", "S78", "S79", "S80"], |node| {
        let normal = Normal3::new(0.3, 1.0, 0.2);
        Ok(node.with(Disc::new(Point3::new(0.0, 0.1, 0.0), normal, 1.5)?))
    }),
];

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let mut cases = Vec::new();
    for (name, ids, shape) in SHAPES {
        for (id, size) in ids.into_iter().zip([1e-6, 1.0, 1e4, 1e9]) {
            let what = format!("{name} under a node of size {size:e}, {count} lit points");
            cases.push(row(id, &what, size, &trials(shape, size, count)));
        }
    }
    cases
}

/// Lit points of a transformed shape, seen from 9 sizes away.
fn trials(shape: Shape, size: f64, count: usize) -> Trials {
    let transform = Transform::IDENTITY
        .translate(Point3::new(0.3 * size, -0.2 * size, 0.7 * size))?
        .rotate_x(0.4)?
        .rotate_y(1.1)?
        .scale(size, 0.5 * size, 2.0 * size)?;
    let middle = transform.matrix() * Point3::ORIGIN;
    let world = Rc::new(world(shape(Node::new(transform))?)?);
    seen(&world, 7, middle, size, [9.0, 0.3], count)
}
