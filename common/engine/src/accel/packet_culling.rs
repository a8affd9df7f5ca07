//! `Bundle`: packets whose rays are close to each other, so that they traverse the tree together,
//! and `PacketSlabs`: packet culling, one packet in each lane.
//!
//! A node is entered if any of the rays may meet it. After the first few leaves, a leaf is tested
//! only against the packets whose own rays may meet it. (Overbeck, Ramamoorthi and Mark, Large Ray
//! Packets for Real-time Whitted Ray Tracing, 2008.)

use arrayvec::ArrayVec;
use fearless_simd::prelude::*;
use glam::DVec3;

use super::slabs::{Slab, Slabs, slack};
use super::tree_space::TreeSpace;
use crate::lanes::{Lanes, RayPacket, Vector3x4, transposed};

/// Packets of a bundle, at most.
pub(crate) const PACKETS: usize = 16;

/// Packets whose rays are close to each other.
pub(super) struct Bundle<S: Simd> {
    /// All rays, for the eight children of a node.
    pub all: Slabs<S, 2>,
    /// The width added to its slabs, in the space of the tree.
    slack: f64,
}

/// The packets of a bundle: the rays of eight packets, one packet in each lane, for one box.
pub(super) struct PacketSlabs<S: Simd>(ArrayVec<Slabs<S, 2>, { PACKETS / 8 }>);

impl<S: Simd> Bundle<S> {
    /// The bundle of some packets, if their rays are coherent: along no axis do they go
    /// both ways, and up to the distance of 1 they stay within `width`. None if a coordinate of any
    /// ray is not finite, because nothing bounds such a ray.
    #[inline(always)]
    pub fn new(space: &TreeSpace, packets: &[&RayPacket<S>], width: f32) -> Option<Self> {
        let simd = packets[0].simd();
        let (origins, directions) = extremes_of_all(packets)?;
        let origins = origins.map(|o| (o - space.centre) * space.scale);
        let largest = {
            let [min, max] = origins;
            min.abs().max(max.abs()).max_element().max(1.0)
        };
        if !(largest <= 1e30 && are_coherent(origins, directions, width)) {
            return None;
        }
        let dominant_axis = if space.is_exact {
            None
        } else {
            Some(dominant_axis(directions.map(DVec3::abs))?)
        };
        let slack = slack(largest);
        let ([o_min, o_max], [d_min, d_max]) = (origins, directions);
        let all = Slabs {
            axes: [
                Slab::splat(simd, [o_min.x, o_max.x], [d_min.x, d_max.x], slack),
                Slab::splat(simd, [o_min.y, o_max.y], [d_min.y, d_max.y], slack),
                Slab::splat(simd, [o_min.z, o_max.z], [d_min.z, d_max.z], slack),
            ],
            t_min: space.t_min().simd_into(simd),
            dominant_axis,
        };
        Some(Self { all, slack })
    }
}

impl<S: Simd> PacketSlabs<S> {
    /// The packets of a bundle. Not inlined, because the traversal of most bundles ends before
    /// packets are culled.
    #[inline(never)]
    pub fn new(space: &TreeSpace, bundle: &Bundle<S>, packets: &[&RayPacket<S>]) -> Self {
        bundle.all.t_min.simd.vectorize(
            #[inline(always)]
            || {
                let mut eights = ArrayVec::new();
                for packets in packets.chunks(8) {
                    eights.push(Slabs {
                        axes: [
                            slab_of_eight(space, bundle, packets, 0),
                            slab_of_eight(space, bundle, packets, 1),
                            slab_of_eight(space, bundle, packets, 2),
                        ],
                        ..bundle.all
                    });
                }
                Self(eights)
            },
        )
    }

    /// A bit for each packet whose rays may meet a box before its `t_max`.
    #[inline(always)]
    pub fn intersect(&self, planes: &[[f32; 2]; 3], t_max: &[f32; PACKETS]) -> u32 {
        let mut hit = 0;
        for (i, (eight, t_max)) in self.0.iter().zip(t_max.as_chunks().0).enumerate() {
            let (_, hit_by) = eight.intersect(planes, *t_max);
            hit |= hit_by << (8 * i);
        }
        hit
    }
}

/// The rays of eight packets along one axis, one packet in each lane.
#[inline(always)]
fn slab_of_eight<S: Simd>(
    space: &TreeSpace,
    bundle: &Bundle<S>,
    packets: &[&RayPacket<S>],
    axis: usize,
) -> Slab<S, 2> {
    let (centre, scale, slack) = (space.centre[axis], space.scale, bundle.slack);
    let min = |o: Lanes<S>| (o - centre) * scale - slack;
    let max = |o: Lanes<S>| (o - centre) * scale + slack;
    let [o, d] = ends_of_four(packets, 0, axis);
    let [p, e] = ends_of_four(packets, 4, axis);
    Slab::new(
        bundle.all.axes[axis].side,
        [min(o[0]).narrow(min(p[0])), max(o[1]).narrow(max(p[1]))],
        [d[0].narrow(e[0]), d[1].narrow(e[1])],
    )
}

/// Along one axis, the least and the greatest coordinates of the origins and of the directions of four
/// packets from `first` on, one packet in each lane. The last packet repeats.
#[inline(always)]
fn ends_of_four<S: Simd>(
    packets: &[&RayPacket<S>],
    first: usize,
    axis: usize,
) -> [[Lanes<S>; 2]; 2] {
    let packet = |i: usize| packets[(first + i).min(packets.len() - 1)];
    let origins = |i| packet(i).origin.axes()[axis];
    let directions = |i| packet(i).direction.axes()[axis];
    [
        ends([origins(0), origins(1), origins(2), origins(3)]),
        ends([directions(0), directions(1), directions(2), directions(3)]),
    ]
}

/// The least and the greatest of the four lanes of each of four numbers.
#[inline(always)]
fn ends<S: Simd>(lanes: [Lanes<S>; 4]) -> [Lanes<S>; 2] {
    let lanes = transposed(lanes);
    [least_of(lanes), greatest_of(lanes)]
}

/// The least and the greatest coordinates of all origins and of all directions; none if one of
/// them is not finite.
///
/// Of a NaN and a number, `min` and `max` take either, and would lose all that came before a NaN.
/// A sum is finite only if all its terms are.
#[inline(always)]
fn extremes_of_all<S: Simd>(packets: &[&RayPacket<S>]) -> Option<([DVec3; 2], [DVec3; 2])> {
    let (mut origins, mut directions) = ([packets[0].origin; 2], [packets[0].direction; 2]);
    let mut sum = Vector3x4::splat(packets[0].simd(), DVec3::ZERO);
    for rays in packets {
        origins = [origins[0].min(rays.origin), origins[1].max(rays.origin)];
        directions = [
            directions[0].min(rays.direction),
            directions[1].max(rays.direction),
        ];
        sum = sum + (rays.origin + rays.direction);
    }
    let is_finite = (sum.x + sum.y + sum.z).is_finite().all_true();
    is_finite.then(|| (extremes(origins), extremes(directions)))
}

/// Whether rays with these extremes are close to each other, and have directions of about
/// length 1.
#[inline]
fn are_coherent(origins: [DVec3; 2], directions: [DVec3; 2], width: f32) -> bool {
    let ([o_min, o_max], [d_min, d_max]) = (origins, directions);
    let go_both_ways = d_min.cmplt(DVec3::ZERO) & d_max.cmpgt(DVec3::ZERO);
    let spread = (o_max - o_min) + (d_max - d_min);
    // None of them is far from length 1, if one is not and they differ little.
    !go_both_ways.any()
        && spread.max_element() < f64::from(width).min(0.1)
        && (0.75..1.5).contains(&d_min.length_squared())
}

/// The axis along which all vectors between two go farthest, if there is one.
#[inline]
fn dominant_axis([a, b]: [DVec3; 2]) -> Option<usize> {
    let (least, greatest) = (a.min(b), a.max(b));
    let axis = least.max_position();
    let is_dominant = |other| other == axis || greatest[other] < least[axis];
    (0..3).all(is_dominant).then_some(axis)
}

/// The least coordinates of the first four vectors, and the greatest of the others.
#[inline(always)]
fn extremes<S: Simd>([least, greatest]: [Vector3x4<S>; 2]) -> [DVec3; 2] {
    let least = least_of(transposed([least.x, least.y, least.z, least.z]));
    let greatest = greatest_of(transposed([greatest.x, greatest.y, greatest.z, greatest.z]));
    [
        DVec3::new(least[0], least[1], least[2]),
        DVec3::new(greatest[0], greatest[1], greatest[2]),
    ]
}

#[inline(always)]
fn least_of<S: Simd>([a, b, c, d]: [Lanes<S>; 4]) -> Lanes<S> {
    a.min(b).min(c.min(d))
}

#[inline(always)]
fn greatest_of<S: Simd>([a, b, c, d]: [Lanes<S>; 4]) -> Lanes<S> {
    a.max(b).max(c.max(d))
}

#[cfg(test)]
mod tests;
