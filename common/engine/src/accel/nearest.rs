//! `NearestSearch`: a search for the nearest hits of four rays, and `NearestHits`, which it finds.

use glam::DVec3;

use super::Accelerator;
use super::search::{Search, largest};
use super::shapes::{Kind, ShapeId, with_list};
use super::single::Nearest;
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

impl NearestHits {
    /// Whether all four surfaces are the same.
    #[inline]
    pub fn is_one_surface(&self) -> bool {
        let [a, b, c, d] = self.surfaces;
        a == b && a == c && a == d
    }
}

/// A search for the nearest hits of four rays.
pub(crate) struct NearestSearch {
    rays: Rays,
    nearest: Nearest4,
}

/// The nearest hits so far.
#[derive(Clone, Copy)]
struct Nearest4 {
    t: Lanes,
    /// The positions in the list of the shapes hit there; below 0 without a hit.
    orders: Lanes,
    /// The bits of the shapes hit.
    shapes: Lanes,
}

impl NearestSearch {
    /// A search for the active of four rays.
    #[inline]
    pub fn new(packet: &RayPacket, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            nearest: Nearest4 {
                t: Lanes::splat(f64::INFINITY),
                orders: Lanes::splat(-1.0),
                shapes: Lanes::ZERO,
            },
        }
    }

    /// A bit for each ray that hits anything.
    #[inline]
    pub fn hit_mask(&self) -> u32 {
        self.nearest.orders.simd_ge(Lanes::ZERO).to_bitmask()
    }
}

impl Search for NearestSearch {
    type Shared = ();

    #[inline]
    fn rays(&self) -> &Rays {
        &self.rays
    }

    #[inline]
    fn open(&self) -> u32 {
        self.rays.active
    }

    #[inline]
    fn beyond(&self) -> f64 {
        largest(self.nearest.t, self.rays.active)
    }

    /// Takes the nearer hits, and at the same place those of the first shape of the list;
    /// without a branch, because no processor can predict which shape is the nearest.
    #[inline]
    fn take(&mut self, t: Lanes, order: u32, shape: ShapeId, (): &mut ()) {
        let nearest = &mut self.nearest;
        if t.simd_le(nearest.t).to_bitmask() & self.rays.active == 0 {
            return;
        }
        let order = Lanes::splat(order.into());
        let is_first = t.simd_eq(nearest.t) & order.simd_lt(nearest.orders);
        let found = (t.simd_lt(nearest.t) | is_first) & mask(self.rays.active);
        nearest.t = select(found, t, nearest.t);
        nearest.orders = select(found, order, nearest.orders);
        nearest.shapes = select(found, Lanes::splat(shape.to_bits()), nearest.shapes);
    }

    fn search_one_by_one(&mut self, accelerator: &Accelerator, (): &mut ()) {
        let rays = self.rays.packet.to_rays();
        let Nearest4 { t, orders, shapes } = self.nearest;
        let (mut t, mut orders) = (t.to_array(), orders.to_array());
        let mut shapes = shapes.to_array();
        for lane in bits(self.rays.active) {
            let ray = &rays[lane];
            let mut alone = Nearest {
                t: t[lane],
                // Below 0, no hit, becomes 0.
                order: orders[lane] as u32,
                shape: None,
            };
            accelerator.search_nearest(ray, &Rays::one(ray, 0.0), 0.0, &mut alone);
            if let Some(shape) = alone.shape {
                (t[lane], orders[lane]) = (alone.t, alone.order.into());
                shapes[lane] = shape.to_bits();
            }
        }
        self.nearest = Nearest4 {
            t: Lanes::new(t),
            orders: Lanes::new(orders),
            shapes: Lanes::new(shapes),
        };
    }
}

impl Accelerator<'_> {
    /// The hits of a search, shape by shape.
    pub fn hits(&self, search: &NearestSearch) -> NearestHits {
        let NearestSearch { rays, nearest } = search;
        let Nearest4 { t, orders, shapes } = *nearest;
        let hit_mask = search.hit_mask();
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
}
