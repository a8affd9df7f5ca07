//! `Bundle`: searches whose rays are close to each other, so that they go through a tree together.
//!
//! A node is entered if any of the rays may meet it; the shapes of a leaf are tested in those
//! searches whose own rays may meet it. (Overbeck, Ramamoorthi and Mark, Large Ray Packets for
//! Real-time Whitted Ray Tracing, 2008.)

use arrayvec::ArrayVec;
use glam::DVec3;
use wide::{f32x8, f64x8};

use super::bvh::Node;
use super::slabs::{Slab, Slabs, slack};
use super::units::Units;
use crate::lanes::{Lanes, RayPacket, Vector3x4};

/// Searches of a bundle, at most.
pub(crate) const SEARCHES: usize = 16;

/// Searches whose rays are close to each other.
pub(super) struct Bundle {
    /// All rays, for the eight children of a node.
    pub all: Slabs<2>,
    /// A bit for each search.
    every: u32,
    /// The rays of eight searches, one search in each lane, for one child of a node. None if they
    /// are not told apart.
    eights: ArrayVec<Slabs<2>, { SEARCHES / 8 }>,
}

impl Bundle {
    /// A bit for each search whose rays may meet a child of a node before its `beyond`.
    #[inline]
    pub fn meeting(&self, node: &Node, child: usize, beyond: &[f32; SEARCHES]) -> u32 {
        if self.eights.is_empty() {
            return self.every;
        }
        let planes = node.planes_of(child);
        let eights = self.eights.iter().zip(beyond.as_chunks().0);
        (0..).zip(eights).fold(0, |meeting, (i, (eight, beyond))| {
            let (_, met) = eight.enter(&planes, f32x8::new(*beyond));
            meeting | met << (8 * i)
        })
    }
}

impl Units {
    /// A bundle of searches with these rays, if all of them are coherent: they go the same way
    /// along each axis, and up to the distance of 1 their places differ by less than `width`.
    /// Searches that are to be told apart take longer to bundle, and are tested less often.
    #[inline]
    pub fn bundle(
        &self,
        searches: &[&RayPacket],
        width: f32,
        are_told_apart: bool,
    ) -> Option<Bundle> {
        let (origins, directions) = ends_of_all(searches);
        let origins = origins.map(|o| (o - self.centre) * self.per_length);
        let largest = {
            let [min, max] = origins;
            min.abs().max(max.abs()).max_element().max(1.0)
        };
        if !(largest <= 1e30 && are_coherent(origins, directions, width)) {
            return None;
        }
        let main = if self.is_exact {
            None
        } else {
            Some(farthest(directions.map(DVec3::abs))?)
        };
        let slack = slack(largest);
        let from = f32x8::splat(self.from(0.0));
        let slab = |axis: usize| {
            let along = |v: DVec3| v[axis];
            Slab::new(origins.map(along), directions.map(along), slack, |x| {
                f32x8::splat(x as f32)
            })
        };
        let all = Slabs {
            axes: [0, 1, 2].map(slab),
            from,
            main,
        };
        let each = |searches: &[&RayPacket]| {
            let fours = [0, 4].map(|first| self.four(searches, first));
            let slab = |axis: fn(&Vector3x4) -> Lanes| {
                let [origins, directions] = [0, 1].map(|i| {
                    let [a, b] = fours.each_ref().map(|four| four[i].each_ref().map(axis));
                    [0, 1].map(|end| eight(a[end], b[end]))
                });
                Slab::new(origins, directions, f64x8::splat(slack), rounded)
            };
            Slabs {
                axes: AXES.map(slab),
                from,
                main,
            }
        };
        let mut eights = ArrayVec::new();
        if are_told_apart {
            eights.extend(searches.chunks(8).map(each));
        }
        Some(Bundle {
            all,
            every: (1 << searches.len()) - 1,
            eights,
        })
    }

    /// The least and the greatest coordinates, in each lane, of the origins of a search's rays, in
    /// these units, and of their directions. Four searches from `first` on, the last one again
    /// where there are no more.
    #[inline]
    fn four(&self, searches: &[&RayPacket], first: usize) -> [[Vector3x4; 2]; 2] {
        let four = [0, 1, 2, 3].map(|i| searches[(first + i).min(searches.len() - 1)]);
        let in_units = |o| (o - Vector3x4::splat(self.centre)) * Lanes::splat(self.per_length);
        [
            across(&four.map(|rays| rays.origin)).map(in_units),
            across(&four.map(|rays| rays.direction)),
        ]
    }
}

/// The coordinate along each axis.
const AXES: [fn(&Vector3x4) -> Lanes; 3] = [|v| v.x, |v| v.y, |v| v.z];

/// The least and the greatest coordinates of all origins and of all directions.
#[inline]
fn ends_of_all(searches: &[&RayPacket]) -> ([DVec3; 2], [DVec3; 2]) {
    let (mut origins, mut directions) = ([searches[0].origin; 2], [searches[0].direction; 2]);
    for rays in searches {
        let add = |[least, greatest]: &mut [Vector3x4; 2], vectors: Vector3x4| {
            *least = least.least(vectors);
            *greatest = greatest.greatest(vectors);
        };
        add(&mut origins, rays.origin);
        add(&mut directions, rays.direction);
    }
    (extremes(origins), extremes(directions))
}

/// Whether rays with these extremes are close to each other, and have directions of about
/// length 1.
#[inline]
fn are_coherent(origins: [DVec3; 2], directions: [DVec3; 2], width: f32) -> bool {
    let ([o_min, o_max], [d_min, d_max]) = (origins, directions);
    let spread = (o_max - o_min) + (d_max - d_min);
    // None of them is far from length 1, if one is not and they differ little.
    d_min.is_negative_bitmask() == d_max.is_negative_bitmask()
        && spread.max_element() < f64::from(width).min(0.1)
        && (0.75..1.5).contains(&d_min.length_squared())
}

/// The axis along which all vectors between two go farthest, if there is one.
#[inline]
fn farthest([a, b]: [DVec3; 2]) -> Option<usize> {
    let (least, most) = (a.min(b), a.max(b));
    let axis = least.max_position();
    let is_farthest = |other| other == axis || most[other] < least[axis];
    (0..3).all(is_farthest).then_some(axis)
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

/// The least and the greatest coordinates in each of four times four vectors, lane by lane.
#[inline]
fn across(vectors: &[Vector3x4; 4]) -> [Vector3x4; 2] {
    let along = |lanes: [Lanes; 4]| {
        let lanes = Lanes::transpose(lanes);
        [least_of(lanes), greatest_of(lanes)]
    };
    let [x, y, z] = AXES.map(|axis| along(vectors.each_ref().map(axis)));
    [0, 1].map(|end| Vector3x4 {
        x: x[end],
        y: y[end],
        z: z[end],
    })
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

/// In single precision.
#[inline]
fn rounded(numbers: f64x8) -> f32x8 {
    f32x8::new(numbers.to_array().map(|x| x as f32))
}

#[cfg(test)]
mod tests;
