//! The candidates of a [`PerspectiveGrid`] for one ray and for four rays.

use glam::DVec3;

use super::RayBundle;
use super::grid::{Candidate, PerspectiveGrid};
use super::shapes::ShapeId;
use crate::lanes::{Lanes, RayPacket, Vector3x4, select};
use crate::vector::largest_coordinate;
use crate::{Interval, Ray};

impl PerspectiveGrid {
    /// The candidates of a ray that comes from the bundle's point, near ones first, and
    /// the distance of a `t` in the unit of the grid. None if the ray does not belong to
    /// the bundle.
    #[inline]
    pub fn outwards(&self, ray: &Ray) -> Option<(&[Candidate], impl Fn(f64) -> f64)> {
        let (o, d) = (ray.origin, ray.direction);
        let (p, start) = match self.bundle {
            RayBundle::Through(point) if o == point => (d, 0.0),
            RayBundle::Parallel(direction) if d == direction && self.reaches(o) => {
                (o, o.dot(self.gaze))
            }
            _ => return None,
        };
        let near = move |t: f64| (start + t) * self.per_length;
        Some((self.candidates_at(p), near))
    }

    /// The candidates of a ray that goes to the bundle's point and ends there: none
    /// farther from the point than the origin of the ray. None if the ray does not
    /// belong to the bundle.
    #[inline]
    pub fn inwards(&self, ray: &Ray, within: Interval) -> Option<impl Iterator<Item = ShapeId>> {
        let (o, d) = (ray.origin, ray.direction);
        let p = self.relative(o);
        let start = match self.bundle {
            RayBundle::Through(_) => {
                // The point of the ray that is nearest to the point of the bundle.
                let t = -p.dot(d);
                let passes = largest_coordinate(p + d * t) <= self.tolerance;
                (passes && within.max <= t + self.tolerance).then_some(t)
            }
            RayBundle::Parallel(direction) => (d == -direction).then(|| p.dot(self.gaze)),
        };
        let start = start.filter(|_| self.reaches(o))? * self.per_length;
        let between = self.candidates_at(p).iter();
        let between = between.take_while(move |candidate| f64::from(candidate.near) <= start);
        Some(between.map(|candidate| candidate.shape))
    }

    #[inline]
    fn reaches(&self, point: DVec3) -> bool {
        largest_coordinate(point) < self.max_origin
    }

    #[inline]
    fn candidates_at(&self, p: DVec3) -> &[Candidate] {
        let Some([x, y]) = self.place(p) else {
            return &[];
        };
        let x = (x - self.from[0]) * self.per_unit[0];
        let y = (y - self.from[1]) * self.per_unit[1];
        self.candidates_of(self.cell(x, y))
    }

    /// The cell at a place counted in cells; outside of the grid, the extra empty one.
    #[inline]
    fn cell(&self, x: f64, y: f64) -> usize {
        let side = self.side as f64;
        if (0.0..side).contains(&x) && (0.0..side).contains(&y) {
            (y as u32 * self.side as u32 + x as u32) as usize
        } else {
            self.side * self.side
        }
    }

    /// Like `outwards`, for a packet. None if an active ray does not belong to the
    /// bundle.
    #[inline]
    pub fn packet_outwards(&self, rays: &RayPacket, active: u32) -> Option<PacketCells<'_>> {
        let (o, d) = (rays.origin, rays.direction);
        let (p, start) = match self.bundle {
            RayBundle::Through(point) if are_all(o, point, active) => (d, Lanes::ZERO),
            RayBundle::Parallel(direction) if are_all(d, direction, active) => self
                .reach_all(o, active)
                .then(|| (o, o.dot(Vector3x4::splat(self.gaze))))?,
            _ => return None,
        };
        Some(self.packet_cells(p, start, active))
    }

    /// Like `inwards`, for a packet. None if an active ray does not belong to the
    /// bundle.
    #[inline]
    pub fn packet_inwards(
        &self,
        rays: &RayPacket,
        max: Lanes,
        active: u32,
    ) -> Option<PacketCells<'_>> {
        let (o, d) = (rays.origin, rays.direction);
        let (p, start) = match self.bundle {
            RayBundle::Through(point) => {
                let p = o - Vector3x4::splat(point);
                let t = -p.dot(d);
                let tolerance = Lanes::splat(self.tolerance);
                let beside = (p + d * t).largest_coordinate();
                let passes = beside.simd_le(tolerance) & max.simd_le(t + tolerance);
                (active & !passes.to_bitmask() == 0).then_some((p, t))?
            }
            RayBundle::Parallel(direction) => {
                let is_parallel = are_all(d, -direction, active);
                let start = o.dot(Vector3x4::splat(self.gaze));
                is_parallel.then_some((o, start))?
            }
        };
        self.reach_all(o, active)
            .then(|| self.packet_cells(p, start, active))
    }

    #[inline]
    fn reach_all(&self, points: Vector3x4, active: u32) -> bool {
        let reach = Lanes::splat(self.max_origin);
        let reaches = points.largest_coordinate().simd_lt(reach).to_bitmask();
        active & !reaches == 0
    }

    #[inline]
    fn packet_cells(&self, p: Vector3x4, start: Lanes, active: u32) -> PacketCells<'_> {
        let mut x = p.dot(Vector3x4::splat(self.right));
        let mut y = p.dot(Vector3x4::splat(self.up));
        if let RayBundle::Through(_) = self.bundle {
            let depth = p.dot(Vector3x4::splat(self.gaze));
            // Points behind the bundle's point have no place.
            let depth = select(depth.simd_gt(Lanes::ZERO), depth, Lanes::splat(f64::NAN));
            (x, y) = (x / depth, y / depth);
        }
        let x = (x - Lanes::splat(self.from[0])) * Lanes::splat(self.per_unit[0]);
        let y = (y - Lanes::splat(self.from[1])) * Lanes::splat(self.per_unit[1]);
        let (x, y) = (x.to_array(), y.to_array());
        PacketCells {
            grid: self,
            of_rays: [0, 1, 2, 3].map(|lane| self.cell(x[lane], y[lane])),
            active,
            start: start * Lanes::splat(self.per_length),
        }
    }
}

/// The cells of four rays of a bundle.
pub(super) struct PacketCells<'a> {
    grid: &'a PerspectiveGrid,
    /// The cell of each ray.
    of_rays: [usize; 4],
    active: u32,
    /// The distances of the origins in the unit of the grid: rays to the bundle's
    /// point hit nothing farther away.
    pub start: Lanes,
}

impl<'a> PacketCells<'a> {
    /// The candidates of the next cell, and a bit for each ray in it.
    #[inline]
    pub fn next(&mut self) -> Option<(&'a [Candidate], u32)> {
        if self.active == 0 {
            return None;
        }
        let cell = self.of_rays[self.active.trailing_zeros() as usize % 4];
        let is_in = |lane: usize| u32::from(self.of_rays[lane] == cell) << lane;
        let lanes = self.active & (is_in(0) | is_in(1) | is_in(2) | is_in(3));
        self.active &= !lanes;
        Some((self.grid.candidates_of(cell), lanes))
    }

    /// The distances of these `t` in the unit of the grid.
    #[inline]
    pub fn near(&self, t: Lanes) -> Lanes {
        self.start + t * Lanes::splat(self.grid.per_length)
    }
}

/// Whether all vectors in the active lanes are this one.
#[inline]
fn are_all(vectors: Vector3x4, one: DVec3, active: u32) -> bool {
    let one = Vector3x4::splat(one);
    let same = vectors.x.simd_eq(one.x) & vectors.y.simd_eq(one.y) & vectors.z.simd_eq(one.z);
    active & !same.to_bitmask() == 0
}
