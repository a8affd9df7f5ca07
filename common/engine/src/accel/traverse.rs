//! The traversal, in two forms. Rays through neighbouring pixels, or from neighbouring points to a
//! light, meet much the same nodes: so the packets of a bundle traverse the tree together while
//! their rays are close to each other. Otherwise each half of them tries the same, and so on; and
//! a packet whose rays are too far apart traverses it ray by ray.
//!
//! (Wald, Slusallek, Benthin and Wagner, Interactive Rendering with Coherent Ray Tracing, 2001.)

use std::ops::ControlFlow;
use std::slice;

use arrayvec::ArrayVec;
use fearless_simd::f32x8;
use fearless_simd::prelude::*;
use glam::DVec3;

use super::bvh::Bvh;
use super::ids::{Kind, Leaf};
use super::packet_culling::{Bundle, PACKETS, PacketSlabs};
use super::query::Query;
use super::shapes::with_list;
use super::slabs::Slabs;
use super::{Accelerator, Occluder};
use crate::Ray;
use crate::lanes::{RayPacket, bits, is_set, mask, splat};
use crate::shape::Rays;

/// The rays of a bundle stay within this many mean widths of a leaf.
const BUNDLE_WIDTH: f32 = 2.0;

/// Packets are culled from the third leaf on. Preparing that takes time, and many bundles meet no
/// more leaves.
const CULL_PACKETS_AFTER: u32 = 2;

/// A linear scan is faster for up to this many packets, if there are few shapes.
const LINEAR_SCAN_PACKETS: usize = 4;

impl Accelerator<'_> {
    /// Carries out these queries, at most [`PACKETS`].
    #[inline(always)]
    pub fn traverse<S: Simd>(&self, queries: &mut [Query<S>], occluder: &mut Occluder) {
        for query in &mut *queries {
            if let Some(shape) = *occluder {
                self.test_all(&[Leaf::of(shape)], slice::from_mut(query), occluder);
            }
        }
        self.traverse_after_guess(queries, occluder);
    }

    fn traverse_after_guess<S: Simd>(&self, queries: &mut [Query<S>], occluder: &mut Occluder) {
        let Some(first) = queries.iter().find(|query| query.active != 0) else {
            return;
        };
        first.simd().vectorize(
            #[inline(always)]
            || {
                if queries.len() <= LINEAR_SCAN_PACKETS && !self.linear_scan.is_empty() {
                    return self.test_all(&self.linear_scan, queries, occluder);
                }
                let Some(tree) = &self.tree else {
                    return self.test_all(&self.unbounded, queries, occluder);
                };
                let width = BUNDLE_WIDTH * tree.leaf_width;
                let bundle =
                    packets(queries).and_then(|rays| Bundle::new(&tree.space, &rays, width));
                if let Some(bundle) = bundle {
                    self.test_all(&self.unbounded, queries, occluder);
                    self.traverse_packets(tree, &bundle, queries, occluder);
                } else if let [query] = queries {
                    self.traverse_ray_by_ray(tree, query, occluder);
                } else {
                    let (some, others) = queries.split_at_mut(queries.len() / 2);
                    self.traverse_after_guess(some, occluder);
                    self.traverse_after_guess(others, occluder);
                }
            },
        );
    }

    /// Carries out a query whose rays may have directions of any length.
    #[inline(always)]
    pub fn traverse_rays<S: Simd>(&self, query: &mut Query<S>) {
        let occluder = &mut None;
        match &self.tree {
            _ if query.active == 0 => (),
            _ if !self.linear_scan.is_empty() => {
                self.test_all(&self.linear_scan, slice::from_mut(query), occluder);
            }
            Some(tree) => self.traverse_ray_by_ray(tree, query, occluder),
            None => self.test_all(&self.unbounded, slice::from_mut(query), occluder),
        }
    }

    #[inline(always)]
    fn traverse_ray_by_ray<S: Simd>(
        &self,
        tree: &Bvh,
        query: &mut Query<S>,
        occluder: &mut Occluder,
    ) {
        self.test_all(&self.unbounded, slice::from_mut(query), occluder);
        let rays = query.rays.packet.to_rays();
        for lane in bits(query.active) {
            self.traverse_ray(tree, &rays[lane], query, lane, occluder);
        }
    }

    /// Carries out the queries of a bundle.
    #[inline(always)]
    fn traverse_packets<S: Simd>(
        &self,
        tree: &Bvh,
        bundle: &Bundle<S>,
        queries: &mut [Query<S>],
        occluder: &mut Occluder,
    ) {
        let simd = bundle.all.t_min.simd;
        let mut t_max = [f32::NEG_INFINITY; PACKETS];
        for (t_max, query) in t_max.iter_mut().zip(&*queries) {
            *t_max = tree.space.t_max(greatest_t(query));
        }
        let all = (1 << queries.len()) - 1;
        let (mut leaves, mut culling) = (0, None);
        let _ = tree.traverse(&bundle.all, greatest(simd, &t_max), |leaf, node, child| {
            if leaves == CULL_PACKETS_AFTER && queries.len() > 1 {
                culling = packets(queries).map(|rays| PacketSlabs::new(&tree.space, bundle, &rays));
            }
            leaves += 1;
            let candidates = culling.as_ref().map_or(all, |packets: &PacketSlabs<S>| {
                packets.intersect(&node.planes_of(child), &t_max)
            });
            self.test(leaf, queries, candidates, occluder);
            for i in bits(candidates) {
                t_max[i] = tree.space.t_max(greatest_t(&queries[i]));
            }
            let t_max = greatest(simd, &t_max);
            if t_max < 0.0 {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(t_max)
        });
    }

    /// Carries out the query of one ray, which is that of a lane. Visits all leaves if the ray does
    /// not fit into the space of the tree, where its direction has the length 1.
    #[inline(never)]
    fn traverse_ray<S: Simd>(
        &self,
        tree: &Bvh,
        ray: &Ray,
        query: &mut Query<S>,
        lane: usize,
        occluder: &mut Occluder,
    ) {
        let simd = query.simd();
        simd.vectorize(
            #[inline(always)]
            || {
                let rays = Rays::one(simd, ray);
                let length = length_unless_1(ray.direction);
                let in_tree = Ray {
                    direction: ray.direction / length,
                    ..*ray
                };
                let t_max = |query: &Query<S>| tree.space.t_max(query.t_max[lane] * length);
                let first_t_max = t_max(query);
                let mut visit = |leaf: Leaf| {
                    let t_max_of_hits = query.t_max[lane];
                    let (t, near) = with_list!(self.shapes, leaf.kind, |list| list.test_ray(
                        leaf,
                        &rays,
                        t_max_of_hits
                    ));
                    for i in bits(near) {
                        let shape = leaf.shape(i as u32);
                        let order = self.shapes.attributes(shape).order;
                        query.update_ray(lane, t[i], order, shape, &self.shapes, occluder);
                    }
                    if !is_set(query.active, lane) {
                        return ControlFlow::Break(());
                    }
                    ControlFlow::Continue(t_max(query))
                };
                let _ = match Slabs::of_ray(simd, &tree.space, &in_tree) {
                    Some(slabs) => tree.traverse(&slabs, first_t_max, |leaf, _, _| visit(leaf)),
                    None => tree.visit_all(visit),
                };
            },
        );
    }

    /// Tests shapes against the packets of all of these queries.
    #[inline(always)]
    fn test_all<S: Simd>(
        &self,
        leaves: &[Leaf],
        queries: &mut [Query<S>],
        occluder: &mut Occluder,
    ) {
        for leaf in leaves {
            self.test(*leaf, queries, (1 << queries.len()) - 1, occluder);
        }
    }

    /// Tests shapes against the packets of some of these queries, a bit for each.
    #[inline(always)]
    fn test<S: Simd>(
        &self,
        leaf: Leaf,
        queries: &mut [Query<S>],
        tested: u32,
        occluder: &mut Occluder,
    ) {
        if tested != 0 {
            with_list!(self.shapes, leaf.kind, |list| list.test_packets(
                &self.shapes,
                leaf,
                queries,
                tested,
                occluder
            ));
        }
    }
}

/// The length of a direction; 1 if it is not clearly another one.
#[inline]
fn length_unless_1(direction: DVec3) -> f64 {
    let squared = direction.length_squared();
    if (squared - 1.0).abs() < 1e-9 {
        1.0
    } else {
        squared.sqrt()
    }
}

/// The rays of these queries, if any is active. The rays of the first active one stand in for those
/// of queries that are over, which must not keep the others apart.
#[inline(always)]
fn packets<'a, S: Simd>(
    queries: &'a [Query<'_, S>],
) -> Option<ArrayVec<&'a RayPacket<S>, PACKETS>> {
    let first = queries.iter().find(|query| query.active != 0)?;
    let packets = queries.iter().map(|query| match query.active {
        0 => &first.rays.packet,
        _ => &query.rays.packet,
    });
    Some(packets.collect())
}

/// The greatest `t` at which a hit of an active ray counts; negative if no hit counts: if none is
/// active, or the `t` of all are NaN, because a light of a student's own has such a distance.
#[inline(always)]
fn greatest_t<S: Simd>(query: &Query<S>) -> f64 {
    let t_max = query.t_max;
    let inactive = splat(t_max.simd, f64::NEG_INFINITY);
    let [a, b, c, d] = *mask(t_max.simd, query.active).select(t_max, inactive);
    a.max(b).max(c.max(d)).max(f64::NEG_INFINITY)
}

#[inline(always)]
fn greatest<S: Simd>(simd: S, t_max: &[f32; PACKETS]) -> f32 {
    let (eights, _) = t_max.as_chunks::<8>();
    let all: f32x8<S> = eights[0].simd_into(simd);
    let all = all.max(eights[1]);
    all.into_iter()
        .fold(f32::NEG_INFINITY, |a, b| if a > b { a } else { b })
}
