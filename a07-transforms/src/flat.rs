//! `Flat`: nodes within nodes, as nodes side by side.
//!
//! A ray that goes down through k nodes is moved k times. The product of their
//! matrices moves it at once, but rounds otherwise: each of both ways errs by up
//! to k times the rounding of a product of a matrix and a point.

use std::sync::Arc;

use a03_rays_cameras::Ray;
use a04_intersections::{Bounds, Geometry, Hit, Interval};
use common::ArgumentError;
use measure::tally::{self, Work};

use crate::{Mat4x4, Node, Transform};

/// A tree of nodes as a list: each has the product of the transforms that lead to
/// its children, none of which is a node.
#[derive(Debug)]
pub struct Flat {
    nodes: Vec<Arc<Node>>,
    replaced: usize,
    slope: f64,
    offset: f64,
}

impl Flat {
    /// The same as a node that has nodes within it, up to rounding. None if it
    /// has none, or if the products hold too large numbers for a [`Transform`].
    #[must_use]
    pub fn new(node: &Node) -> Option<Self> {
        let mut flat = Self {
            nodes: Vec::new(),
            replaced: 0,
            slope: 0.0,
            offset: 0.0,
        };
        flat.add(node, &Chain::of(node.transform())).ok()?;
        (flat.replaced > 1).then_some(flat)
    }

    /// How far it seems to be from where the nodes are that it stands for: each
    /// ray passes each shape as if that had been moved by less than this length.
    /// True for rays that start, and hit something, within the distance `reach`
    /// of the origin.
    ///
    /// What is hit differs by that length over the cosine of the angle to the
    /// normal, besides the rounding of the formula of the shape.
    #[must_use]
    pub const fn shift(&self, reach: f64) -> f64 {
        self.slope * reach + self.offset
    }

    /// How many nodes it stands for.
    pub(crate) const fn replaced(&self) -> usize {
        self.replaced
    }

    pub(crate) fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter().map(|node| &**node)
    }

    /// Adds what is in a node to which this chain leads.
    fn add(&mut self, node: &Node, chain: &Chain) -> Result<(), ArgumentError> {
        self.replaced += 1;
        let mut own = Vec::new();
        for child in node.children() {
            if let Some(inner) = Node::of(&**child) {
                self.add(inner, &chain.then(inner.transform())?)?;
            } else {
                own.push(Arc::clone(child));
            }
        }
        if !own.is_empty() {
            self.slope = self.slope.max(chain.slope());
            self.offset = self.offset.max(chain.offset());
            self.nodes.push(Arc::new(Node::over(chain.transform, own)));
        }
        Ok(())
    }
}

impl Geometry for Flat {
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        tally::count_all(Work::IntersectionTest, self.nodes.len() as u64);
        let mut nearest = None;
        for node in &self.nodes {
            if let Some(hit) = node.hit(ray, within) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }

    fn bounds(&self) -> Bounds {
        let all = self.nodes.iter().map(|node| node.bounds());
        all.reduce(Bounds::union).unwrap_or(Bounds::EVERYWHERE)
    }

    fn parts(&self) -> Option<Vec<Arc<dyn Geometry>>> {
        let parts = |node: &Arc<Node>| {
            let own = || vec![Arc::clone(node) as _];
            node.parts().unwrap_or_else(own)
        };
        Some(self.nodes.iter().flat_map(parts).collect())
    }
}

/// More than the error of both ways for each node passed, relative to the largest
/// number on the way.
///
/// An inverse `i` takes a point at the distance r from the origin to one at most
/// r' = |i| r + c away, with its spectral norm |i| and the length c of its last
/// column, and rounds by at most √3 γ₄ r'. (γ₄ is hardly more than 2 eps; Higham,
/// Accuracy and Stability of Numerical Algorithms, 2002, section 3.5; the norm of
/// the magnitudes of three by three numbers is at most √3 |i|.) The nodes that
/// follow stretch this no more than r', so that k nodes err by at most k √3 γ₄
/// times the last distance. The product of the matrices is computed in the same
/// way column by column: with three columns it errs by 3 γ₄, and that for k - 1
/// products and for the ray. Both ways together stay below 10 eps; the norms are
/// rounded, too.
const PER_NODE: f64 = 16.0 * f64::EPSILON;

/// The transforms that lead to a node, and what they make of lengths.
struct Chain {
    transform: Transform,
    nodes: u32,
    /// A point at the distance r is at most `inwards` r + `far` from the origin,
    /// for the innermost node.
    inwards: f64,
    far: f64,
    /// Lengths of the innermost node are at most so many times as long outside.
    outwards: f64,
}

impl Chain {
    fn of(transform: &Transform) -> Self {
        Self {
            transform: *transform,
            nodes: 1,
            inwards: norm(transform.inverse()),
            far: last_column(transform.inverse()),
            outwards: norm(transform.matrix()),
        }
    }

    fn then(&self, inner: &Transform) -> Result<Self, ArgumentError> {
        let one = Self::of(inner);
        Ok(Self {
            transform: self.transform.after(inner)?,
            nodes: self.nodes + 1,
            inwards: one.inwards * self.inwards,
            far: one.inwards * self.far + one.far,
            outwards: self.outwards * one.outwards,
        })
    }

    /// A single node is kept as it is.
    fn rounding(&self) -> f64 {
        if self.nodes == 1 {
            0.0
        } else {
            PER_NODE * f64::from(self.nodes) * self.outwards
        }
    }

    /// A ray o + t d errs at a place x by what o errs and t times what d does.
    /// Together they are no longer than o and x - o: three times the reach.
    fn slope(&self) -> f64 {
        self.rounding() * 3.0 * self.inwards
    }

    fn offset(&self) -> f64 {
        self.rounding() * self.far
    }
}

/// At least the spectral norm of the upper left three by three numbers `a`, and
/// equal to it if they turn, and stretch evenly: |a|² = |aᵀ a|, and no norm is
/// above the largest sum of a row's magnitudes.
fn norm(matrix: Mat4x4) -> f64 {
    let a = matrix.rows();
    let product = |i: usize, j: usize| (0..3).map(|k| a[k][i] * a[k][j]).sum::<f64>();
    let sums = [0, 1, 2].map(|i| (0..3).map(|j| product(i, j).abs()).sum());
    sums.into_iter().fold(0.0, f64::max).sqrt()
}

fn last_column(matrix: Mat4x4) -> f64 {
    let squares = matrix.rows().into_iter().take(3).map(|row| row[3] * row[3]);
    squares.sum::<f64>().sqrt()
}
