//! The search for four rays at once. Where they have to ask the same shapes, as
//! neighbours mostly have, they ask together; else each for itself.

use std::cell::OnceCell;

use a02_math::vector3x4::{mask, select};
use a02_math::{Lanes, Normal3, Vector3x4};
use a03_rays_cameras::RayPacket;
use measure::tally::{self, Work};

use super::Search;
use super::shapes::{Asking, Shape, Shapes};
use crate::packet::{PacketHit, ShearedRays};
use crate::{Hit, Interval};

/// The nearest hits of four rays.
#[derive(Clone, Copy, Debug)]
pub struct Hits {
    /// A bit for each ray that meets anything.
    pub met: u32,
    /// Where, and which way the surfaces face there: towards the rays.
    pub hit: PacketHit,
    /// The objects that they meet.
    pub objects: [u32; 4],
}

impl Search {
    /// The nearest hits of the rays whose bits are set in `active`.
    #[inline]
    #[must_use]
    pub fn hit_together(&self, rays: &RayPacket, active: u32) -> Hits {
        let asking = AskingTogether::new(rays, active, &self.shapes);
        let mut nearest = Nearest::new(&asking);
        for shape in &self.unbounded {
            nearest.ask(*shape, active);
        }
        let mut pencils = self.pencils.iter();
        if let Some(mut cells) = pencils.find_map(|pencil| pencil.outwards_together(rays, active)) {
            while let Some((entries, active)) = cells.next() {
                for entry in entries {
                    let near = Lanes::splat(entry.near.into());
                    let beyond = near.simd_gt(cells.near(nearest.t)).to_bitmask();
                    if active & !beyond == 0 {
                        break;
                    }
                    nearest.ask(entry.shape, active & !beyond);
                }
            }
        } else if let Some(few) = &self.few {
            for shape in few {
                nearest.ask(*shape, active);
            }
        } else {
            return self.hit_one_by_one(rays, active);
        }
        nearest.hits()
    }

    /// A bit for each ray of those in `active` that meets anything before `max`.
    #[inline]
    #[must_use]
    pub fn is_hit_together(&self, rays: &RayPacket, max: Lanes, active: u32) -> u32 {
        let asking = AskingTogether::new(rays, active, &self.shapes);
        let mut open = active;
        let mut ask = |shape: Shape, active: u32| {
            let active = active & open;
            if active != 0 {
                tally::count_all(Work::IntersectionTest, active.count_ones().into());
                let met = asking.t(shape, max, active).simd_lt(max);
                open &= !(met.to_bitmask() & active);
            }
            open != 0
        };
        if !self.unbounded.iter().all(|shape| ask(*shape, active)) {
            return active;
        }
        let mut pencils = self.pencils.iter();
        let of_pencil = pencils.find_map(|pencil| pencil.inwards_together(rays, max, active));
        if let Some(mut cells) = of_pencil {
            while let Some((entries, active)) = cells.next() {
                for entry in entries {
                    let near = Lanes::splat(entry.near.into());
                    let beyond = near.simd_gt(cells.start).to_bitmask();
                    if active & !beyond == 0 || !ask(entry.shape, active & !beyond) {
                        break;
                    }
                }
            }
        } else if let Some(few) = &self.few {
            few.iter().all(|shape| ask(*shape, active));
        } else {
            return (active & !open) | self.is_hit_one_by_one(rays, max, open);
        }
        active & !open
    }

    #[inline(never)]
    fn hit_one_by_one(&self, rays: &RayPacket, active: u32) -> Hits {
        let alone = rays.to_rays();
        let (mut met, mut objects, mut hits) = (0, [0; 4], [NOTHING; 4]);
        for (lane, ray) in alone.iter().enumerate() {
            if active >> lane & 1 != 0
                && let Some((hit, object)) = self.hit(ray, Interval::AHEAD)
            {
                met |= 1 << lane;
                (objects[lane], hits[lane]) = (object as u32, hit);
            }
        }
        let hit = PacketHit::new(hits);
        let mut hits = Hits { met, hit, objects };
        hits.turn_against(rays);
        hits
    }

    #[inline(never)]
    fn is_hit_one_by_one(&self, rays: &RayPacket, max: Lanes, active: u32) -> u32 {
        let (rays, max) = (rays.to_rays(), max.to_array());
        let is_hit = |lane: usize| self.is_hit(&rays[lane], Interval::before(max[lane]));
        let lanes = (0..4).filter(|lane| active >> lane & 1 != 0 && is_hit(*lane));
        lanes.map(|lane| 1 << lane).sum()
    }
}

const NOTHING: Hit = Hit::new(f64::NAN, Normal3::new(0.0, 0.0, 0.0));

impl PacketHit {
    /// These four hits.
    #[inline]
    fn new(hits: [Hit; 4]) -> Self {
        Self {
            t: Lanes::new(hits.map(|hit| hit.t)),
            normal: Vector3x4::new(hits.map(|hit| hit.normal.to_glam())),
            face: Vector3x4::new(hits.map(|hit| hit.face.to_glam())),
        }
    }
}

impl Hits {
    /// Turns the normals towards the side that the rays come from.
    #[inline]
    fn turn_against(&mut self, rays: &RayPacket) {
        let from_behind = self.hit.face.dot(rays.direction).simd_gt(Lanes::ZERO);
        self.hit.normal = self.hit.normal.negated(from_behind);
        self.hit.face = self.hit.face.negated(from_behind);
    }
}

/// Four rays that ask shapes.
struct AskingTogether<'a> {
    rays: &'a RayPacket,
    /// A bit for each that asks at all.
    active: u32,
    shapes: &'a Shapes,
    sheared: OnceCell<Option<ShearedRays>>,
}

impl<'a> AskingTogether<'a> {
    #[inline]
    fn new(rays: &'a RayPacket, active: u32, shapes: &'a Shapes) -> Self {
        Self {
            rays,
            active,
            shapes,
            sheared: OnceCell::new(),
        }
    }

    #[inline]
    fn sheared(&self) -> Option<&ShearedRays> {
        let sheared = self
            .sheared
            .get_or_init(|| ShearedRays::new(self.rays, self.active));
        sheared.as_ref()
    }

    /// Where each ray of those in `active` meets the shape. What is beyond `max`
    /// does not count, and may be NaN like what is not met.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    fn t(&self, shape: Shape, max: Lanes, active: u32) -> Lanes {
        let Self { rays, shapes, .. } = self;
        match shape {
            Shape::Sphere(i) => shapes.spheres[i as usize].0.meet(rays),
            Shape::Plane(i) => shapes.planes[i as usize].0.meet(rays),
            Shape::Box(i) => shapes.boxes[i as usize].0.meet(rays),
            Shape::Triangle(i) if let Some(rays) = self.sheared() => {
                shapes.triangles[i as usize].0.meet(rays).t
            }
            _ => self.one_by_one(shape, max, active).t,
        }
    }

    /// All that there is to the hits of a shape that it meets at these `t`.
    #[inline]
    fn hit(&self, shape: Shape, t: Lanes, active: u32) -> PacketHit {
        let Self { rays, shapes, .. } = self;
        match shape {
            Shape::Sphere(i) => shapes.spheres[i as usize].0.hits(rays, t),
            Shape::Plane(i) => shapes.planes[i as usize].0.hits(t),
            Shape::Box(i) => shapes.boxes[i as usize].0.hits(rays),
            Shape::Triangle(i) if let Some(rays) = self.sheared() => {
                let triangle = &shapes.triangles[i as usize].0;
                triangle.hits(triangle.meet(rays))
            }
            _ => self.one_by_one(shape, t, active),
        }
    }

    /// What the shape answers if it has no formula for four of these rays.
    #[inline(never)]
    fn one_by_one(&self, shape: Shape, max: Lanes, active: u32) -> PacketHit {
        let (rays, max) = (self.rays.to_rays(), max.to_array());
        PacketHit::new([0, 1, 2, 3].map(|lane| {
            if active >> lane & 1 == 0 {
                return NOTHING;
            }
            let within = Interval::before(max[lane].next_up());
            let asking = Asking::new(&rays[lane], self.shapes);
            asking.answer(shape, within).unwrap_or(NOTHING)
        }))
    }
}

/// The nearest hits so far.
struct Nearest<'a> {
    asking: &'a AskingTogether<'a>,
    t: Lanes,
    /// The turns of the shapes that are met there; below 0 where nothing is.
    turns: Lanes,
}

impl<'a> Nearest<'a> {
    #[inline]
    fn new(asking: &'a AskingTogether<'a>) -> Self {
        Self {
            asking,
            t: Lanes::splat(f64::INFINITY),
            turns: Lanes::splat(-1.0),
        }
    }

    /// Takes what is nearer, and at the same place what comes first in the list; without
    /// a branch, for which shape is the nearest no processor can foretell.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    fn ask(&mut self, shape: Shape, active: u32) {
        tally::count_all(Work::IntersectionTest, active.count_ones().into());
        let t = self.asking.t(shape, self.t, active);
        let turn = Lanes::splat(self.asking.shapes.turn(shape).turn.into());
        let is_first = t.simd_eq(self.t) & turn.simd_lt(self.turns);
        let found = (t.simd_lt(self.t) | is_first) & mask(active);
        self.t = select(found, t, self.t);
        self.turns = select(found, turn, self.turns);
    }

    /// All that there is to the hits, shape by shape.
    #[inline]
    fn hits(self) -> Hits {
        let Self { asking, t, turns } = self;
        let met = turns.simd_ge(Lanes::ZERO).to_bitmask();
        let nothing = Vector3x4::splat(glam::DVec3::ZERO);
        let mut hits = Hits {
            met,
            hit: PacketHit {
                t,
                normal: nothing,
                face: nothing,
            },
            objects: [0; 4],
        };
        let of_lanes = turns.to_array();
        let mut open = met;
        while open != 0 {
            let turn = of_lanes[open.trailing_zeros() as usize % 4];
            let same = turns.simd_eq(Lanes::splat(turn)).to_bitmask();
            let shape = asking.shapes.in_turn[turn as usize];
            let hit = asking.hit(shape, t, same);
            let object = asking.shapes.turn(shape).object;
            if met & !same == 0 {
                hits.hit = hit;
                hits.objects = [object; 4];
                break;
            }
            hits.hit = hit.or(mask(same), hits.hit);
            for (lane, of_lane) in hits.objects.iter_mut().enumerate() {
                if same >> lane & 1 != 0 {
                    *of_lane = object;
                }
            }
            open &= !same;
        }
        hits.turn_against(asking.rays);
        hits
    }
}
