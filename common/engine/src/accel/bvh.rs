//! `Bvh`: a bounding volume hierarchy, which finds the few shapes near a ray among
//! many. It is eight wide: one instruction tests a ray against the children of a node.
//!
//! (Wald, Benthin and Boulos, Getting Rid of Packets, 2008.)
//!
//! It only chooses candidates, so its bounds may be coarse, but must never be too
//! small: they are single precision numbers, rounded outwards.

use std::ops::ControlFlow;

use super::ids::Leaf;
use super::slabs::{Slabs, WIDTH};
use super::tree_space::TreeSpace;
use crate::lanes::{Simd, bits};
use arrayvec::ArrayVec;

/// Most levels of a tree; see `bvh_build`.
pub(super) const LEVELS: usize = 32;

/// A tree of shapes with finite bounds.
#[derive(Debug)]
pub(super) struct Bvh {
    pub space: TreeSpace,
    /// The last one is the root.
    pub nodes: Vec<Node>,
    /// The mean width of a leaf, in the space of the tree.
    pub leaf_width: f32,
}

/// The bounds of the children, axis by axis: the lower and the upper ones.
#[derive(Debug)]
#[repr(align(32))]
pub(super) struct Node {
    pub planes: [[[f32; WIDTH]; 2]; 3],
    pub children: [Child; WIDTH],
}

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Child {
    Node(u32),
    Leaf(Leaf),
}

impl Node {
    /// The bounds of one child.
    #[inline]
    pub fn planes_of(&self, child: usize) -> [[f32; 2]; 3] {
        self.planes.map(|sides| sides.map(|planes| planes[child]))
    }
}

/// A child that is still to be visited: the bits of the `t` at which the rays enter it, and below
/// them its index among the children of all nodes, which has 32 bits up to 137 GB of nodes. Bits of
/// numbers from 0 on grow with them, so the lesser of two entries is the nearer one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct StackEntry(u64);

impl StackEntry {
    #[inline]
    fn new(t: f32, node: u32, lane: usize) -> Self {
        let child = node * WIDTH as u32 + lane as u32;
        Self(u64::from(t.to_bits()) << 32 | u64::from(child))
    }

    #[inline]
    fn t(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// The index of its node, and of the child in it.
    #[inline]
    fn child(self) -> (usize, usize) {
        let child = self.0 as u32 as usize;
        (child / WIDTH, child % WIDTH)
    }
}

/// Sorts the last entry into the others, which are in descending order. Without a branch, because
/// no processor can predict which child is nearer.
#[inline]
fn sort_last(stack: &mut [StackEntry]) {
    for i in (1..stack.len()).rev() {
        let (a, b) = (stack[i - 1], stack[i]);
        (stack[i - 1], stack[i]) = (a.max(b), a.min(b));
    }
}

impl Bvh {
    /// Visits the leaves that rays may meet before `t_max`, in the space of the tree, near ones
    /// first, each with its node and its index in it. `visit` returns the new `t_max`, or ends the
    /// traversal.
    #[inline(always)]
    pub fn traverse<S: Simd, const N: usize>(
        &self,
        slabs: &Slabs<S, N>,
        mut t_max: f32,
        mut visit: impl FnMut(Leaf, &Node, usize) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        let mut stack = ArrayVec::<StackEntry, { (WIDTH - 1) * LEVELS + 1 }>::new();
        let mut child = Child::Node(self.nodes.len() as u32 - 1);
        // Its node, and its index in it; the root has none.
        let mut at = (0, 0);
        loop {
            match child {
                Child::Leaf(leaf) => t_max = visit(leaf, &self.nodes[at.0], at.1)?,
                Child::Node(index) => {
                    let node = &self.nodes[index as usize];
                    let (t, hit) = slabs.intersect(&node.planes, t_max);
                    if hit.is_power_of_two() {
                        at = (index as usize, hit.trailing_zeros() as usize % WIDTH);
                        child = node.children[at.1];
                        continue;
                    }
                    let first = stack.len();
                    for lane in bits(hit) {
                        stack.push(StackEntry::new(t[lane % WIDTH], index, lane));
                        sort_last(&mut stack[first..]);
                    }
                }
            }
            child = loop {
                let Some(nearest) = stack.pop() else {
                    return ControlFlow::Continue(());
                };
                if nearest.t() <= t_max {
                    at = nearest.child();
                    break self.nodes[at.0].children[at.1];
                }
            };
        }
    }

    /// Visits all leaves.
    pub fn visit_all(
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
