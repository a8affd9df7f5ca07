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
pub(super) struct Leaf {
    pub kind: Kind,
    /// From 1 to 4.
    pub count: u8,
    pub first: u32,
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

impl Bvh {
    /// Visits the leaves that rays may meet before `beyond`, in the units of the tree, near
    /// ones first. `visit` returns `beyond` updated, or breaks off.
    #[inline]
    pub fn search<const N: usize>(
        &self,
        slabs: &Slabs<N>,
        mut beyond: f32,
        mut visit: impl FnMut(Leaf) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        let mut open = ArrayVec::<(f32, Child), { (WIDTH - 1) * LEVELS + 1 }>::new();
        let root = self.nodes.len() as u32 - 1;
        open.push((f32::NEG_INFINITY, Child::Node(root)));
        while let Some((first_hit, child)) = open.pop() {
            if first_hit > beyond {
                continue;
            }
            let index = match child {
                Child::Node(index) => index,
                Child::Leaf(leaf) => {
                    beyond = visit(leaf)?;
                    continue;
                }
            };
            let node = &self.nodes[index as usize];
            let (first_hit, mut met) = slabs.enter(&node.planes, beyond);
            let first = open.len();
            while met != 0 {
                let lane = met.trailing_zeros() as usize % WIDTH;
                met &= met - 1;
                // The stack returns the nearest child first.
                let mut place = open.len();
                open.push((first_hit[lane], node.children[lane]));
                while place > first && open[place - 1].0 < open[place].0 {
                    open.swap(place - 1, place);
                    place -= 1;
                }
            }
        }
        ControlFlow::Continue(())
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
