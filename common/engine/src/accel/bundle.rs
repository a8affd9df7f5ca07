//! `Bundle`: searches whose rays are close to each other, so that they go through a tree together.
//!
//! A node is entered if any of the rays may meet it. The shapes of a leaf are tested in all
//! searches, and after the first few leaves only in those whose own rays may meet it. (Overbeck,
//! Ramamoorthi and Mark, Large Ray Packets for Real-time Whitted Ray Tracing, 2008.)

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
    /// How much wider its slabs are, in the units of the tree.
    slack: f64,
}

/// The searches of a bundle, told apart: the rays of eight searches, one search in each lane, for
/// one child of a node.
pub(super) struct Members(ArrayVec<Slabs<2>, { SEARCHES / 8 }>);

impl Members {
    /// A bit for each search whose rays may meet a child of a node before its `beyond`.
    #[inline]
    pub fn meeting(&self, node: &Node, child: usize, beyond: &[f32; SEARCHES]) -> u32 {
        let planes = node.planes_of(child);
        let eights = self.0.iter().zip(beyond.as_chunks().0);
        (0..).zip(eights).fold(0, |meeting, (i, (eight, beyond))| {
            let (_, met) = eight.enter(&planes, f32x8::new(*beyond));
            meeting | met << (8 * i)
        })
    }
}

impl Units {
    /// A bundle of searches with these rays, if all of them are coherent: they go the same way
    /// along each axis, and up to the distance of 1 their places differ by less than `width`.
    #[inline]
    pub fn bundle(&self, searches: &[&RayPacket], width: f32) -> Option<Bundle> {
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
        Some(Bundle { all, slack })
    }

    /// The searches of a bundle, which have these rays. Not inlined, because most bundles end before
    /// their searches are told apart.
    #[inline(never)]
    pub fn members(&self, bundle: &Bundle, searches: &[&RayPacket]) -> Members {
        let eights = searches.chunks(8).map(|searches| {
            let fours = [0, 4].map(|first| self.four(searches, first));
            let slab = |axis: usize| {
                let [origins, directions] = [0, 1].map(|i| {
                    let [a, b] = fours.map(|four| four[i][axis]);
                    [0, 1].map(|end| eight(a[end], b[end]))
                });
                Slab::new(origins, directions, f64x8::splat(bundle.slack), rounded)
            };
            Slabs {
                axes: [0, 1, 2].map(slab),
                ..bundle.all
            }
        });
        Members(eights.collect())
    }

    /// The least and the greatest coordinates along each axis, in each lane, of the origins of a
    /// search's rays, in these units, and of their directions. Four searches from `first` on, the
    /// last one again where there are no more.
    #[inline]
    fn four(&self, searches: &[&RayPacket], first: usize) -> [[[Lanes; 2]; 3]; 2] {
        let four = [0, 1, 2, 3].map(|i| searches[(first + i).min(searches.len() - 1)]);
        let origins = across(&four.map(|rays| rays.origin));
        let in_units = |axis: usize| {
            let centre = Lanes::splat(self.centre[axis]);
            origins[axis].map(|o| (o - centre) * Lanes::splat(self.per_length))
        };
        [
            [0, 1, 2].map(in_units),
            across(&four.map(|rays| rays.direction)),
        ]
    }
}

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

/// The least and the greatest coordinates along each axis in each of four times four vectors, lane
/// by lane.
#[inline]
fn across(vectors: &[Vector3x4; 4]) -> [[Lanes; 2]; 3] {
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

/// In single precision.
#[inline]
fn rounded(numbers: f64x8) -> f32x8 {
    f32x8::new(numbers.to_array().map(|x| x as f32))
}

#[cfg(test)]
mod tests;
