//! `Bvh`: a bounding volume hierarchy, which finds the few shapes near a ray among
//! many.
//!
//! It only chooses candidates, so its bounds may be coarse, but must never be too
//! small: they are single precision numbers, rounded outwards.

use std::ops::ControlFlow;

use arrayvec::ArrayVec;
use glam::DVec3;
use wide::f32x4;

use super::bvh_build;
use super::shapes::ShapeId;
use crate::shape::Bounds;
use crate::{Interval, Ray};

/// Children of a node, and shapes of a leaf.
pub(crate) const WIDTH: usize = 4;
/// Most levels of a tree; see `bvh_build`.
pub(super) const LEVELS: usize = 32;

/// A tree over leaves `L` of up to four shapes.
#[derive(Debug)]
pub(super) struct Bvh<L> {
    /// The tree measures from its centre in units of half its extent, so that
    /// every scene, tiny or huge, near or far, fills the range from -1 to 1.
    centre: DVec3,
    per_length: f64,
    pub(super) nodes: Vec<Node>,
    pub(super) leaves: Vec<L>,
}

/// The bounds of four children, axis by axis: the lower and the upper ones.
#[derive(Debug)]
pub(super) struct Node {
    planes: [[f32x4; 2]; 3],
    children: [Child; WIDTH],
}

/// The index of a node, or with the highest bit set the index of a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(u32);

impl Child {
    const LEAF: u32 = 1 << 31;

    pub const fn node(index: usize) -> Self {
        Self(index as u32)
    }

    pub const fn leaf(index: usize) -> Self {
        Self(index as u32 | Self::LEAF)
    }
}

/// Bounds are widened by this share of the largest number, in the units of the tree, so
/// that they hold every hit that a shape computes. The single precision of the slab
/// test and of its ray moves a hit by less than a quarter of it, and the double
/// precision of the shapes by far less.
const SLACK: f64 = 1.0 / 1_048_576.0;

impl<L> Bvh<L> {
    /// The tree of shapes with finite bounds; `leaf` gathers up to four.
    pub fn new(shapes: Vec<(Bounds, ShapeId)>, leaf: impl FnMut(&[ShapeId]) -> L) -> Self {
        let all = Bounds::of_all(shapes.iter().map(|(bounds, _)| *bounds));
        let extent = (0..3).map(|axis| all.max[axis] / 2.0 - all.min[axis] / 2.0);
        let mut tree = Self {
            centre: all.middle().into(),
            per_length: 1.0 / extent.fold(f64::MIN_POSITIVE, f64::max),
            nodes: Vec::new(),
            leaves: Vec::new(),
        };
        bvh_build::grow(&mut tree, shapes, leaf);
        tree
    }

    pub(super) fn node(&self, children: &[(Bounds, Child)]) -> Node {
        let mut planes = [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3];
        for (lane, (bounds, _)) in children.iter().enumerate() {
            for (axis, [min, max]) in planes.iter_mut().enumerate() {
                let own = |x: f64| ((x - self.centre[axis]) * self.per_length) as f32;
                min[lane] = own(bounds.min[axis]).next_down();
                max[lane] = own(bounds.max[axis]).next_up();
            }
        }
        let child = |lane| {
            children
                .get(lane)
                .map_or(Child::node(0), |(_, child)| *child)
        };
        Node {
            planes: planes.map(|sides| sides.map(f32x4::new)),
            children: std::array::from_fn(child),
        }
    }

    /// Visits the leaves that the ray may meet within the interval, near ones first,
    /// and all leaves if the ray does not fit into the units of the tree. `visit` gets
    /// the largest `t` of interest, and returns it updated or breaks off.
    #[inline]
    pub fn search(
        &self,
        ray: &Ray,
        within: Interval,
        mut visit: impl FnMut(&L, f64) -> ControlFlow<(), f64>,
    ) -> ControlFlow<(), f64> {
        let mut max = within.max;
        let Some(slabs) = self.slabs(ray, within) else {
            return self
                .leaves
                .iter()
                .try_fold(max, |max, leaf| visit(leaf, max));
        };
        let mut beyond = self.beyond(within.max);
        let mut open = ArrayVec::<(f32, Child), { (WIDTH - 1) * LEVELS + 1 }>::new();
        open.push((f32::NEG_INFINITY, Child::node(0)));
        while let Some((near, child)) = open.pop() {
            if near > beyond {
                continue;
            }
            if child.0 & Child::LEAF != 0 {
                let leaf = &self.leaves[(child.0 & !Child::LEAF) as usize];
                max = visit(leaf, max)?;
                beyond = self.beyond(max);
                continue;
            }
            let node = &self.nodes[child.0 as usize];
            let (near, mut met) = slabs.enter(&node.planes, beyond);
            let first = open.len();
            while met != 0 {
                let lane = met.trailing_zeros() as usize;
                met &= met - 1;
                // The stack returns the nearest child first.
                let entry = (near[lane], node.children[lane]);
                let waiting = &open[first..];
                let place = waiting.iter().position(|(far, _)| *far < entry.0);
                open.insert(first + place.unwrap_or(waiting.len()), entry);
            }
        }
        ControlFlow::Continue(max)
    }

    /// A `t` in the units of the tree, rounded up.
    fn beyond(&self, t: f64) -> f32 {
        (t * self.per_length * (1.0 + SLACK)) as f32
    }

    /// The ray in the units of the tree. None if it starts too far away for them, or
    /// if its direction is far from length 1.
    #[inline]
    fn slabs(&self, ray: &Ray, within: Interval) -> Option<Slabs> {
        let (o, d) = (ray.origin, ray.direction);
        let o = (o - self.centre) * self.per_length;
        let largest = o.abs().max_element().max(1.0);
        if largest > 1e30 || !(0.5..2.0).contains(&d.length_squared()) || within.min < 0.0 {
            return None;
        }
        let slack = 2.0 * largest * SLACK;
        Some(Slabs {
            x: Slab::new(o.x, d.x, slack),
            y: Slab::new(o.y, d.y, slack),
            z: Slab::new(o.z, d.z, slack),
            from: f32x4::splat((within.min * self.per_length * (1.0 - SLACK)) as f32),
        })
    }
}

/// A ray, prepared for the slab test.
struct Slabs {
    x: Slab,
    y: Slab,
    z: Slab,
    from: f32x4,
}

/// One axis of a ray for the slab test.
struct Slab {
    /// The index of the plane of the slab that the ray meets first.
    side: usize,
    near: f32x4,
    far: f32x4,
    inverse: f32x4,
}

impl Slab {
    #[inline]
    fn new(o: f64, d: f64, slack: f64) -> Self {
        let slack = slack.copysign(d);
        // A ray parallel to the slab gets a huge finite inverse, which avoids
        // 0 * infinity.
        let inverse = (1.0 / d as f32).clamp(-1e30, 1e30);
        Self {
            // The direction -0 counts as downwards, like all others with a negative inverse.
            side: usize::from(d.is_sign_negative()),
            near: f32x4::splat((o + slack) as f32),
            far: f32x4::splat((o - slack) as f32),
            inverse: f32x4::splat(inverse),
        }
    }

    /// The `t` at which the ray enters and leaves four slabs.
    #[inline]
    fn enter(&self, planes: &[f32x4; 2]) -> (f32x4, f32x4) {
        let near = (planes[self.side] - self.near) * self.inverse;
        let far = (planes[self.side ^ 1] - self.far) * self.inverse;
        (near, far)
    }
}

impl Slabs {
    /// The `t` at which the ray enters the four children, and a bit for each that it
    /// meets.
    #[inline]
    fn enter(&self, [x, y, z]: &[[f32x4; 2]; 3], beyond: f32) -> ([f32; WIDTH], u32) {
        let ((nx, fx), (ny, fy), (nz, fz)) = (self.x.enter(x), self.y.enter(y), self.z.enter(z));
        let near = nx.fast_max(ny).fast_max(nz.fast_max(self.from));
        let far = fx.fast_min(fy).fast_min(fz.fast_min(f32x4::splat(beyond)));
        (near.to_array(), near.simd_le(far).to_bitmask())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Its centre is the origin and its unit 2, so that all numbers are exact.
    fn tree() -> Bvh<()> {
        let bounds = Bounds {
            min: [-2.0; 3],
            max: [2.0; 3],
        };
        Bvh::new(vec![(bounds, ShapeId::Sphere(0))], |_| ())
    }

    fn ray(x: f64, direction: [f64; 3]) -> Ray {
        Ray {
            origin: DVec3::new(x, 0.0, 0.0),
            direction: direction.into(),
        }
    }

    fn all(lanes: f32x4) -> f32 {
        let [first, rest @ ..] = lanes.to_array();
        assert!(rest.iter().all(|lane| *lane == first));
        first
    }

    const TO_THE_RIGHT: [f64; 3] = [1.0, 0.0, 0.0];
    const SLACK: f32 = super::SLACK as f32;

    #[test]
    fn lengths_are_counted_in_the_unit_of_the_tree_and_bounds_are_wider() {
        assert_eq!(tree().beyond(8.0), 4.0 + 4.0 * SLACK);
        let within = Interval { min: 4.0, max: 8.0 };
        let slabs = tree().slabs(&ray(-4.0, TO_THE_RIGHT), within).unwrap();
        assert_eq!(all(slabs.from), 2.0 - 2.0 * SLACK);
        // Twice the slack of the largest number, which is 2, and at least of 1.
        assert_eq!(all(slabs.x.near), -2.0 + 4.0 * SLACK);
        assert_eq!(all(slabs.x.far), -2.0 - 4.0 * SLACK);
        assert_eq!(all(slabs.y.near), 4.0 * SLACK);
        let slabs = tree().slabs(&ray(1.0, [-1.0, 0.0, 0.0]), within).unwrap();
        assert_eq!(all(slabs.x.near), 0.5 - 2.0 * SLACK);
        assert_eq!(all(slabs.x.far), 0.5 + 2.0 * SLACK);
    }

    /// Each of the three reasons counts alone.
    #[test]
    fn a_ray_beyond_single_precision_visits_all_leaves() {
        let holds = |x, direction, min| {
            let max = f64::INFINITY;
            let within = Interval { min, max };
            tree().slabs(&ray(x, direction), within).is_some()
        };
        assert!(holds(2e30, TO_THE_RIGHT, 0.0));
        assert!(!holds(2e30_f64.next_up(), TO_THE_RIGHT, 0.0));
        assert!(!holds(0.0, TO_THE_RIGHT, -f64::MIN_POSITIVE));
        // Of squared length 1/2 and 2.
        assert!(holds(0.0, [0.5, 0.5, 0.0], 0.0));
        assert!(!holds(0.0, [0.5, 0.5_f64.next_down(), 0.0], 0.0));
        assert!(!holds(0.0, [1.0, 1.0, 0.0], 0.0));
        assert!(holds(0.0, [1.0, 1.0_f64.next_down(), 0.0], 0.0));
    }
}
