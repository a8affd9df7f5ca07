//! `Bvh`: a bounding volume hierarchy, which finds the few shapes near a ray among
//! many. It is eight wide: one instruction tests a ray against the children of a node.
//!
//! (Wald, Benthin and Boulos, Getting Rid of Packets, 2008.)
//!
//! It only chooses candidates, so its bounds may be coarse, but must never be too
//! small: they are single precision numbers, rounded outwards.

use std::ops::ControlFlow;

use arrayvec::ArrayVec;
use wide::f32x8;

use super::shapes::{Kind, ShapeId};
use super::slabs::Slabs;
use super::units::Units;
use crate::lanes::bits;

/// Children of a node.
pub(super) const WIDTH: usize = 8;
/// Most levels of a tree; see `bvh_build`.
pub(super) const LEVELS: usize = 32;

/// A tree of shapes with finite bounds.
#[derive(Debug)]
pub(super) struct Bvh {
    pub units: Units,
    /// The last one is the root.
    pub nodes: Vec<Node>,
    /// The mean width of a leaf, in the units of the tree.
    pub leaf_width: f32,
}

/// The bounds of the children, axis by axis: the lower and the upper ones.
#[derive(Debug)]
pub(super) struct Node {
    pub planes: [[f32x8; 2]; 3],
    pub children: [Child; WIDTH],
}

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Child {
    Node(u32),
    Leaf(Leaf),
}

/// Shapes of one kind that lie side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Leaf {
    pub kind: Kind,
    /// From 1 to 4.
    pub count: u8,
    pub first: u32,
}

impl Node {
    /// The bounds of one child, in all lanes.
    #[inline]
    pub fn planes_of(&self, child: usize) -> [[f32x8; 2]; 3] {
        let lane = |planes: &f32x8| f32x8::splat(planes.as_array()[child]);
        self.planes.each_ref().map(|ends| ends.each_ref().map(lane))
    }
}

impl Leaf {
    /// A leaf of one shape.
    pub const fn of(shape: ShapeId) -> Self {
        Self {
            kind: shape.kind,
            count: 1,
            first: shape.index,
        }
    }

    /// A shape of the leaf.
    #[inline]
    pub const fn shape(self, i: u32) -> ShapeId {
        ShapeId {
            kind: self.kind,
            index: self.first + i,
        }
    }
}

/// A child that is still to be visited: the bits of the `t` before which no ray hits its shapes,
/// and below them its place among the children of all nodes, which has 32 bits up to 137 GB of
/// nodes. Bits of numbers from 0 on grow with them, so the lesser of two is the nearer one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Open(u64);

impl Open {
    #[inline]
    fn new(first_hit: f32, node: u32, lane: usize) -> Self {
        let child = node * WIDTH as u32 + lane as u32;
        Self(u64::from(first_hit.to_bits()) << 32 | u64::from(child))
    }

    #[inline]
    fn first_hit(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// The index of its node, and of the child in it.
    #[inline]
    fn child(self) -> (usize, usize) {
        let child = self.0 as u32 as usize;
        (child / WIDTH, child % WIDTH)
    }
}

/// Puts the last element where it belongs among the others, which are in descending order.
/// Without a branch, because no processor can predict which child is nearer.
#[inline]
fn nearest_last(open: &mut [Open]) {
    for i in (1..open.len()).rev() {
        let (a, b) = (open[i - 1], open[i]);
        (open[i - 1], open[i]) = (a.max(b), a.min(b));
    }
}

impl Bvh {
    /// Visits the leaves that rays may meet before `beyond`, in the units of the tree, near
    /// ones first, each with its node and its number there. `visit` returns `beyond` updated, or
    /// breaks off.
    #[inline]
    pub fn search<const N: usize>(
        &self,
        slabs: &Slabs<N>,
        mut beyond: f32,
        mut visit: impl FnMut(Leaf, &Node, usize) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        let mut open = ArrayVec::<Open, { (WIDTH - 1) * LEVELS + 1 }>::new();
        let mut child = Child::Node(self.nodes.len() as u32 - 1);
        // Its node, and its number there; the root has none.
        let mut place = (0, 0);
        loop {
            match child {
                Child::Leaf(leaf) => beyond = visit(leaf, &self.nodes[place.0], place.1)?,
                Child::Node(index) => {
                    let node = &self.nodes[index as usize];
                    let (first_hit, met) = slabs.enter(&node.planes, f32x8::splat(beyond));
                    if met.is_power_of_two() {
                        place = (index as usize, met.trailing_zeros() as usize % WIDTH);
                        child = node.children[place.1];
                        continue;
                    }
                    let first = open.len();
                    for lane in bits(met) {
                        open.push(Open::new(first_hit[lane % WIDTH], index, lane));
                        nearest_last(&mut open[first..]);
                    }
                }
            }
            child = loop {
                let Some(nearest) = open.pop() else {
                    return ControlFlow::Continue(());
                };
                if nearest.first_hit() <= beyond {
                    place = nearest.child();
                    break self.nodes[place.0].children[place.1];
                }
            };
        }
    }

    /// Visits all leaves.
    pub fn search_all(
        &self,
        mut visit: impl FnMut(Leaf) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        let children = self.nodes.iter().flat_map(|node| node.children);
        for child in children {
            if let Child::Leaf(leaf) = child {
                visit(leaf)?;
            }
        }
        ControlFlow::Continue(())
    }
}
