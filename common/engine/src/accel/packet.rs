//! The nearest hits, and any hits, of four rays: together while they go the same way, and
//! otherwise one by one.

use std::ops::ControlFlow;

use glam::DVec3;

use super::bvh::{Bvh, Leaf};
use super::shapes::{Kind, ShapeId, with_list};
use super::single::Nearest;
use super::slabs::Slabs;
use super::{Accelerator, COHERENT};
use crate::Interval;
use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4, bits, mask, select};
use crate::shape::{Primitive, Rays};

/// The nearest hits of four rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearestHits {
    /// A bit for each ray that hits anything.
    pub hit_mask: u32,
    /// The hits, their normals turned against the rays.
    pub hit: PacketHit,
    /// The surfaces that are hit.
    pub surfaces: [u32; 4],
}

/// A shape that has kept away the light of a source, which the next rays to it may meet
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

impl Accelerator<'_> {
    /// The nearest hits of the active rays. `near` are the only shapes that they may meet, if
    /// these are known.
    pub fn hit_packet(
        &self,
        packet: &RayPacket,
        active: u32,
        near: Option<&[Leaf]>,
    ) -> NearestHits {
        let rays = Rays::four(packet, active);
        let mut nearest = Nearest4::new();
        let test = |leaf: Leaf, nearest: &mut Nearest4| {
            with_list!(self.shapes, leaf.kind, |list| {
                list.nearest_of_four(leaf, &rays, active, nearest);
            });
        };
        for leaf in near.unwrap_or(&self.scanned) {
            test(*leaf, &mut nearest);
        }
        if let Some(tree) = &self.tree {
            let beyond = |nearest: &Nearest4| tree.units.beyond(largest(nearest.t, active));
            let first = beyond(&nearest);
            let visit = |leaf| {
                test(leaf, &mut nearest);
                ControlFlow::Continue(beyond(&nearest))
            };
            let _ = match tree.way(packet, active) {
                Way::Bundle(slabs) => tree.search(&slabs, first, visit),
                Way::AllLeaves => tree.search_all(visit),
                Way::OneByOne => self.nearest_one_by_one(packet, active, &mut nearest),
            };
        }
        self.hits(&rays, nearest)
    }

    fn nearest_one_by_one(
        &self,
        packet: &RayPacket,
        active: u32,
        nearest: &mut Nearest4,
    ) -> ControlFlow<()> {
        let rays = packet.to_rays();
        let (mut t, mut orders) = (nearest.t.to_array(), nearest.orders.to_array());
        let mut shapes = nearest.shapes.to_array();
        for lane in bits(active) {
            let ray = &rays[lane];
            let mut alone = Nearest {
                t: t[lane],
                // Below 0, no hit, becomes 0.
                order: orders[lane] as u32,
                shape: None,
            };
            self.search_nearest(ray, &Rays::one(ray, 0.0), 0.0, &mut alone);
            if let Some(shape) = alone.shape {
                (t[lane], orders[lane]) = (alone.t, alone.order.into());
                shapes[lane] = shape.to_bits();
            }
        }
        *nearest = Nearest4 {
            t: Lanes::new(t),
            orders: Lanes::new(orders),
            shapes: Lanes::new(shapes),
        };
        ControlFlow::Continue(())
    }

    /// The hits, shape by shape.
    fn hits(&self, rays: &Rays, nearest: Nearest4) -> NearestHits {
        let Nearest4 { t, orders, shapes } = nearest;
        let hit_mask = orders.simd_ge(Lanes::ZERO).to_bitmask();
        let mut hit = PacketHit::with_normals(t, Vector3x4::splat(DVec3::ZERO));
        let mut surfaces = [0; 4];
        let shapes = shapes.to_array();
        let mut open = hit_mask;
        while open != 0 {
            let lane = open.trailing_zeros() as usize % 4;
            let order = Lanes::splat(orders.to_array()[lane]);
            let same = orders.simd_eq(order).to_bitmask();
            let shape = ShapeId::from_bits(shapes[lane]);
            let (of_shape, surface) = with_list!(self.shapes, shape.kind, |list| {
                let hits = list.get(shape.index).hits(rays, t, same);
                (hits, list.places[shape.index as usize].surface)
            });
            if hit_mask & !same == 0 {
                hit = of_shape;
                surfaces = [surface; 4];
                break;
            }
            hit = of_shape.or(mask(same), hit);
            for lane in bits(same) {
                surfaces[lane] = surface;
            }
            open &= !same;
        }
        NearestHits {
            hit_mask,
            hit: hit.facing(&rays.packet),
            surfaces,
        }
    }

    /// A bit for each active ray that hits anything before `max`. `occluder` is tested
    /// first, and renewed.
    pub fn is_hit_packet(
        &self,
        packet: &RayPacket,
        max: Lanes,
        active: u32,
        occluder: &mut Occluder,
    ) -> u32 {
        let rays = Rays::four(packet, active);
        let mut shadow = Shadow {
            open: active,
            occluder: *occluder,
        };
        let test = |leaf: Leaf, shadow: &mut Shadow| {
            let (hit, i) = with_list!(self.shapes, leaf.kind, |list| {
                list.any_of_four(leaf, &rays, max, shadow.open)
            });
            if hit != 0 {
                *shadow = Shadow {
                    open: shadow.open & !hit,
                    occluder: Some(leaf.shape(i)),
                };
            }
            shadow.open == 0
        };
        let last = occluder.map(Leaf::of);
        let mut first = last.iter().chain(&self.scanned);
        if !first.any(|leaf| test(*leaf, &mut shadow))
            && let Some(tree) = &self.tree
        {
            let active = shadow.open;
            let beyond = tree.units.beyond(largest(max, active));
            let visit = |leaf| {
                if test(leaf, &mut shadow) {
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(beyond)
            };
            let _ = match tree.way(packet, active) {
                Way::Bundle(slabs) => tree.search(&slabs, beyond, visit),
                Way::AllLeaves => tree.search_all(visit),
                Way::OneByOne => self.any_one_by_one(packet, max, &mut shadow),
            };
        }
        *occluder = shadow.occluder;
        active & !shadow.open
    }

    fn any_one_by_one(
        &self,
        packet: &RayPacket,
        max: Lanes,
        shadow: &mut Shadow,
    ) -> ControlFlow<()> {
        let (rays, max) = (packet.to_rays(), max.to_array());
        for lane in bits(shadow.open) {
            let ray = &rays[lane];
            let within = Interval::before(max[lane]);
            let found = self.search_any(ray, &Rays::one(ray, 0.0), within);
            if found.is_some() {
                shadow.open &= !(1 << lane);
                shadow.occluder = found;
            }
        }
        ControlFlow::Continue(())
    }
}

/// How rays pass through a tree.
#[expect(
    clippy::large_enum_variant,
    reason = "it lives for a moment, on the stack"
)]
enum Way {
    /// Together.
    Bundle(Slabs<2>),
    /// Together, testing all shapes.
    AllLeaves,
    OneByOne,
}

impl Bvh {
    /// The way of the active of four rays: together while they are coherent. Otherwise the
    /// shapes of a single node are sooner tested than told apart.
    #[inline]
    fn way(&self, packet: &RayPacket, active: u32) -> Way {
        if active.is_power_of_two() {
            // A ray alone.
            return Way::OneByOne;
        }
        let width = COHERENT * self.leaf_width;
        match self.units.bundle(packet, active, width) {
            Some(slabs) => Way::Bundle(slabs),
            None if self.nodes.len() == 1 => Way::AllLeaves,
            None => Way::OneByOne,
        }
    }
}

/// The rays that have not hit anything yet, and the shape hit last.
struct Shadow {
    open: u32,
    occluder: Occluder,
}

/// The largest of some lanes.
#[inline]
fn largest(lanes: Lanes, active: u32) -> f64 {
    let [a, b, c, d] = (lanes & mask(active)).to_array();
    a.max(b).max(c.max(d))
}

/// The nearest hits so far.
#[derive(Clone, Copy)]
pub(super) struct Nearest4 {
    pub t: Lanes,
    /// The positions in the list of the shapes hit there; below 0 without a hit.
    orders: Lanes,
    /// The bits of the shapes hit.
    shapes: Lanes,
}

impl Nearest4 {
    fn new() -> Self {
        Self {
            t: Lanes::splat(f64::INFINITY),
            orders: Lanes::splat(-1.0),
            shapes: Lanes::ZERO,
        }
    }

    /// Takes the nearer hits of a shape, and at the same place the first of the list;
    /// without a branch, because no processor can predict which shape is the nearest.
    #[inline]
    pub fn take(&mut self, t: Lanes, order: u32, shape: ShapeId, active: u32) {
        let order = Lanes::splat(order.into());
        let is_first = t.simd_eq(self.t) & order.simd_lt(self.orders);
        let found = (t.simd_lt(self.t) | is_first) & mask(active);
        self.t = select(found, t, self.t);
        self.orders = select(found, order, self.orders);
        self.shapes = select(found, Lanes::splat(shape.to_bits()), self.shapes);
    }
}
