//! `Bundle`: packets whose rays are close to each other, so that they traverse the tree together,
//! and `PacketSlabs`: packet culling, one packet in each lane.
//!
//! A node is entered if any of the rays may meet it. After the first few leaves, a leaf is tested
//! only against the packets whose own rays may meet it. (Overbeck, Ramamoorthi and Mark, Large Ray
//! Packets for Real-time Whitted Ray Tracing, 2008.)

use arrayvec::ArrayVec;
use glam::DVec3;
use wide::{f32x8, f64x8};

use super::slabs::{Side, Slab, Slabs, slack};
use super::tree_space::TreeSpace;
use crate::lanes::{Lanes, RayPacket, Vector3x4};

/// Packets of a bundle, at most.
pub(crate) const PACKETS: usize = 16;

/// Packets whose rays are close to each other.
pub(super) struct Bundle {
    /// All rays, for the eight children of a node.
    pub all: Slabs<2>,
    /// The width added to its slabs, in the space of the tree.
    slack: f64,
}

/// The packets of a bundle: the rays of eight packets, one packet in each lane, for one box.
pub(super) struct PacketSlabs(ArrayVec<Slabs<2>, { PACKETS / 8 }>);

impl Bundle {
    /// The bundle of some packets, if their rays are coherent: along no axis do they go
    /// both ways, and up to the distance of 1 they stay within `width`. None if a coordinate of any
    /// ray is not finite, because nothing bounds such a ray.
    #[inline]
    pub fn new(space: &TreeSpace, packets: &[&RayPacket], width: f32) -> Option<Self> {
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
        let slab = |axis: usize| {
            let [origins, directions] = [origins, directions].map(|ends| ends.map(|v| v[axis]));
            let splat = |x: f64| f32x8::splat(x as f32);
            Slab::new(Side::of(directions[0]), origins, directions, slack, splat)
        };
        let all = Slabs {
            axes: [0, 1, 2].map(slab),
            t_min: f32x8::splat(space.t_min()),
            dominant_axis,
        };
        Some(Self { all, slack })
    }
}

impl PacketSlabs {
    /// The packets of a bundle. Not inlined, because the traversal of most bundles ends before
    /// packets are culled.
    #[inline(never)]
    pub fn new(space: &TreeSpace, bundle: &Bundle, packets: &[&RayPacket]) -> Self {
        let eights = packets.chunks(8).map(|packets| {
            let fours = [0, 4].map(|first| extremes_of_four(space, packets, first));
            let slab = |axis: usize| {
                let [origins, directions] = [0, 1].map(|i| {
                    let [a, b] = fours.map(|four| four[i][axis]);
                    [0, 1].map(|end| eight(a[end], b[end]))
                });
                let side = bundle.all.axes[axis].side;
                let slack = f64x8::splat(bundle.slack);
                let single = |numbers: f64x8| f32x8::new(numbers.to_array().map(|x| x as f32));
                Slab::new(side, origins, directions, slack, single)
            };
            Slabs {
                axes: [0, 1, 2].map(slab),
                ..bundle.all
            }
        });
        Self(eights.collect())
    }

    /// A bit for each packet whose rays may meet a box before its `t_max`.
    #[inline]
    pub fn intersect(&self, planes: &[[f32x8; 2]; 3], t_max: &[f32; PACKETS]) -> u32 {
        let eights = self.0.iter().zip(t_max.as_chunks().0);
        (0..).zip(eights).fold(0, |hit, (i, (eight, t_max))| {
            let (_, hit_by) = eight.intersect(planes, f32x8::new(*t_max));
            hit | hit_by << (8 * i)
        })
    }
}

/// The least and the greatest coordinates along each axis, in each lane, of the origins of a
/// packet's rays, in the space of the tree, and of their directions. Four packets from `first` on;
/// the last one repeats.
#[inline]
fn extremes_of_four(
    space: &TreeSpace,
    packets: &[&RayPacket],
    first: usize,
) -> [[[Lanes; 2]; 3]; 2] {
    let four = [0, 1, 2, 3].map(|i| packets[(first + i).min(packets.len() - 1)]);
    let origins = extremes_by_packet(&four.map(|rays| rays.origin));
    let in_space = |axis: usize| {
        let centre = Lanes::splat(space.centre[axis]);
        origins[axis].map(|o| (o - centre) * Lanes::splat(space.scale))
    };
    [
        [0, 1, 2].map(in_space),
        extremes_by_packet(&four.map(|rays| rays.direction)),
    ]
}

/// The least and the greatest coordinates of all origins and of all directions; none if one of
/// them is not finite.
///
/// Of a NaN and a number, `min` and `max` take either, and would lose all that came before a NaN.
/// A sum is finite only if all its terms are.
#[inline]
fn extremes_of_all(packets: &[&RayPacket]) -> Option<([DVec3; 2], [DVec3; 2])> {
    let (mut origins, mut directions) = ([packets[0].origin; 2], [packets[0].direction; 2]);
    let mut sum = Vector3x4::splat(DVec3::ZERO);
    for rays in packets {
        let add = |[least, greatest]: &mut [Vector3x4; 2], vectors: Vector3x4| {
            *least = least.min(vectors);
            *greatest = greatest.max(vectors);
        };
        add(&mut origins, rays.origin);
        add(&mut directions, rays.direction);
        sum = sum + (rays.origin + rays.direction);
    }
    let is_finite = (sum.x + sum.y + sum.z).is_finite().all();
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
#[inline]
fn extremes([least, greatest]: [Vector3x4; 2]) -> [DVec3; 2] {
    let lanes = |Vector3x4 { x, y, z }: Vector3x4| Lanes::transpose([x, y, z, z]);
    [least_of(lanes(least)), greatest_of(lanes(greatest))].map(|ends| {
        let [x, y, z, _] = ends.to_array();
        DVec3::new(x, y, z)
    })
}

/// The least and the greatest coordinates along each axis in each of four times four vectors, lane
/// by lane.
#[inline]
fn extremes_by_packet(vectors: &[Vector3x4; 4]) -> [[Lanes; 2]; 3] {
    let along = |axis: fn(&Vector3x4) -> Lanes| {
        let lanes = Lanes::transpose(vectors.each_ref().map(axis));
        [least_of(lanes), greatest_of(lanes)]
    };
    [along(|v| v.x), along(|v| v.y), along(|v| v.z)]
}

#[inline]
fn least_of([a, b, c, d]: [Lanes; 4]) -> Lanes {
    a.fast_min(b).fast_min(c.fast_min(d))
}

#[inline]
fn greatest_of([a, b, c, d]: [Lanes; 4]) -> Lanes {
    a.fast_max(b).fast_max(c.fast_max(d))
}

/// Twice four numbers side by side.
#[inline]
fn eight(a: Lanes, b: Lanes) -> f64x8 {
    let ([a, b, c, d], [e, f, g, h]) = (a.to_array(), b.to_array());
    f64x8::new([a, b, c, d, e, f, g, h])
}

#[cfg(test)]
mod tests;
