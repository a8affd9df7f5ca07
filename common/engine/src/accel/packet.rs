//! The nearest hits, and any hits, of four rays. Rays with the same candidates, as
//! neighbours mostly have, are tested together; others one by one.

use std::cell::OnceCell;

use glam::DVec3;
use measure::tally::{self, Work};

use super::Accelerator;
use super::shapes::{ShapeId, Shapes, SingleRay};
use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4, is_set, mask, select};
use crate::shape::ShearedRays;
use crate::{Hit, Interval};

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

impl Accelerator<'_> {
    /// The nearest hits of the active rays.
    #[inline]
    pub fn hit_packet(&self, rays: &RayPacket, active: u32) -> NearestHits {
        let tests = PacketTests::new(rays, active, &self.shapes);
        let mut nearest = Nearest::new(&tests);
        for shape in &self.unbounded {
            nearest.test(*shape, active);
        }
        let mut grids = self.grids.iter();
        if let Some(mut cells) = grids.find_map(|grid| grid.packet_outwards(rays, active)) {
            while let Some((candidates, active)) = cells.next() {
                for candidate in candidates {
                    let near = Lanes::splat(candidate.near.into());
                    let beyond = near.simd_gt(cells.near(nearest.t)).to_bitmask();
                    if active & !beyond == 0 {
                        break;
                    }
                    nearest.test(candidate.shape, active & !beyond);
                }
            }
        } else if let Some(few) = &self.few {
            for shape in few {
                nearest.test(*shape, active);
            }
        } else {
            return self.hit_one_by_one(rays, active);
        }
        nearest.hits()
    }

    /// A bit for each active ray that hits anything before `max`.
    #[inline]
    pub fn is_hit_packet(&self, rays: &RayPacket, max: Lanes, active: u32) -> u32 {
        let tests = PacketTests::new(rays, active, &self.shapes);
        let mut open = active;
        let mut test = |shape: ShapeId, active: u32| {
            let active = active & open;
            if active != 0 {
                tally::count_all(Work::IntersectionTest, active.count_ones().into());
                let is_hit = tests.t(shape, max, active).simd_lt(max);
                open &= !(is_hit.to_bitmask() & active);
            }
            open != 0
        };
        if !self.unbounded.iter().all(|shape| test(*shape, active)) {
            return active;
        }
        let mut grids = self.grids.iter();
        let of_grid = grids.find_map(|grid| grid.packet_inwards(rays, max, active));
        if let Some(mut cells) = of_grid {
            while let Some((candidates, active)) = cells.next() {
                for candidate in candidates {
                    let near = Lanes::splat(candidate.near.into());
                    let beyond = near.simd_gt(cells.start).to_bitmask();
                    if active & !beyond == 0 || !test(candidate.shape, active & !beyond) {
                        break;
                    }
                }
            }
        } else if let Some(few) = &self.few {
            few.iter().all(|shape| test(*shape, active));
        } else {
            return (active & !open) | self.is_hit_one_by_one(rays, max, open);
        }
        active & !open
    }

    #[inline(never)]
    fn hit_one_by_one(&self, rays: &RayPacket, active: u32) -> NearestHits {
        let alone = rays.to_rays();
        let (mut hit_mask, mut surfaces, mut hits) = (0, [0; 4], [Hit::NONE; 4]);
        for (lane, ray) in alone.iter().enumerate() {
            if is_set(active, lane)
                && let Some((hit, surface)) = self.hit(ray, Interval::AHEAD)
            {
                hit_mask |= 1 << lane;
                (surfaces[lane], hits[lane]) = (surface, hit);
            }
        }
        NearestHits {
            hit_mask,
            hit: PacketHit::new(hits).facing(rays),
            surfaces,
        }
    }

    #[inline(never)]
    fn is_hit_one_by_one(&self, rays: &RayPacket, max: Lanes, active: u32) -> u32 {
        let (rays, max) = (rays.to_rays(), max.to_array());
        let is_hit = |lane: usize| self.is_hit(&rays[lane], Interval::before(max[lane]));
        let lanes = (0..4).filter(|lane| is_set(active, *lane) && is_hit(*lane));
        lanes.map(|lane| 1 << lane).sum()
    }
}

/// Four rays that are tested against shapes.
struct PacketTests<'r, 'a> {
    rays: &'r RayPacket,
    active: u32,
    shapes: &'r Shapes<'a>,
    sheared: OnceCell<Option<ShearedRays>>,
}

impl<'r, 'a> PacketTests<'r, 'a> {
    #[inline]
    fn new(rays: &'r RayPacket, active: u32, shapes: &'r Shapes<'a>) -> Self {
        Self {
            rays,
            active,
            shapes,
            sheared: OnceCell::new(),
        }
    }

    #[inline]
    fn sheared(&self) -> Option<&ShearedRays> {
        let sheared = || ShearedRays::new(self.rays, self.active);
        self.sheared.get_or_init(sheared).as_ref()
    }

    /// Where each active ray hits the shape. Hits beyond `max` do not count, and may be
    /// NaN like misses.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    fn t(&self, shape: ShapeId, max: Lanes, active: u32) -> Lanes {
        let Self { rays, shapes, .. } = self;
        match shape {
            ShapeId::Sphere(i) => shapes.spheres[i as usize].0.meet(rays),
            ShapeId::Plane(i) => shapes.planes[i as usize].0.meet(rays),
            ShapeId::Box(i) => shapes.boxes[i as usize].0.meet(rays),
            ShapeId::Triangle(i) if let Some(rays) = self.sheared() => {
                shapes.triangles[i as usize].0.meet(rays).t
            }
            _ => self.rare(shape, max, active).t,
        }
    }

    /// The hits of a shape at these `t`.
    #[inline]
    fn hits(&self, shape: ShapeId, t: Lanes, active: u32) -> PacketHit {
        let Self { rays, shapes, .. } = self;
        match shape {
            ShapeId::Sphere(i) => shapes.spheres[i as usize].0.hits(rays, t),
            ShapeId::Plane(i) => shapes.planes[i as usize].0.hits(t),
            ShapeId::Box(i) => shapes.boxes[i as usize].0.hits(rays),
            ShapeId::Triangle(i) if let Some(rays) = self.sheared() => {
                let triangle = &shapes.triangles[i as usize].0;
                triangle.hits(triangle.meet(rays))
            }
            _ => self.rare(shape, t, active),
        }
    }

    /// The hits of a shape of the other kinds. They stay out of the loop over
    /// candidates, which is faster with few kinds.
    #[inline(never)]
    fn rare(&self, shape: ShapeId, max: Lanes, active: u32) -> PacketHit {
        if let ShapeId::Disc(i) = shape {
            let disc = &self.shapes.discs[i as usize].0;
            return disc.hits(disc.meet(self.rays));
        }
        self.one_by_one(shape, max, active)
    }

    /// The hits of a shape that has no formula for four of these rays.
    fn one_by_one(&self, shape: ShapeId, max: Lanes, active: u32) -> PacketHit {
        let (rays, max) = (self.rays.to_rays(), max.to_array());
        PacketHit::new([0, 1, 2, 3].map(|lane| {
            if !is_set(active, lane) {
                return Hit::NONE;
            }
            let within = Interval::before(max[lane].next_up());
            let tests = SingleRay::new(&rays[lane], self.shapes);
            tests.hit_uncounted(shape, within).unwrap_or(Hit::NONE)
        }))
    }
}

/// The nearest hits so far.
struct Nearest<'t, 'r, 'a> {
    tests: &'t PacketTests<'r, 'a>,
    t: Lanes,
    /// The positions in the list of the shapes hit there; below 0 without a hit.
    orders: Lanes,
}

impl<'t, 'r, 'a> Nearest<'t, 'r, 'a> {
    #[inline]
    fn new(tests: &'t PacketTests<'r, 'a>) -> Self {
        Self {
            tests,
            t: Lanes::splat(f64::INFINITY),
            orders: Lanes::splat(-1.0),
        }
    }

    /// Takes the nearer hit, and at the same place the first of the list; without a
    /// branch, because no processor can predict which shape is the nearest.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    fn test(&mut self, shape: ShapeId, active: u32) {
        tally::count_all(Work::IntersectionTest, active.count_ones().into());
        let t = self.tests.t(shape, self.t, active);
        let order = Lanes::splat(self.tests.shapes.listed(shape).order.into());
        let is_first = t.simd_eq(self.t) & order.simd_lt(self.orders);
        let found = (t.simd_lt(self.t) | is_first) & mask(active);
        self.t = select(found, t, self.t);
        self.orders = select(found, order, self.orders);
    }

    /// The hits, shape by shape.
    #[inline]
    fn hits(self) -> NearestHits {
        let Self { tests, t, orders } = self;
        let hit_mask = orders.simd_ge(Lanes::ZERO).to_bitmask();
        let mut hit = PacketHit::with_normals(t, Vector3x4::splat(DVec3::ZERO));
        let mut surfaces = [0; 4];
        let of_lanes = orders.to_array();
        let mut open = hit_mask;
        while open != 0 {
            let order = of_lanes[open.trailing_zeros() as usize % 4];
            let same = orders.simd_eq(Lanes::splat(order)).to_bitmask();
            let shape = tests.shapes.in_order[order as usize];
            let of_shape = tests.hits(shape, t, same);
            let surface = tests.shapes.listed(shape).surface;
            if hit_mask & !same == 0 {
                hit = of_shape;
                surfaces = [surface; 4];
                break;
            }
            hit = of_shape.or(mask(same), hit);
            for (lane, of_lane) in surfaces.iter_mut().enumerate() {
                if is_set(same, lane) {
                    *of_lane = surface;
                }
            }
            open &= !same;
        }
        NearestHits {
            hit_mask,
            hit: hit.facing(tests.rays),
            surfaces,
        }
    }
}
