//! `Tracer`: follows the paths of a batch from mirror to mirror, until none is active.
//!
//! All paths take each step together: first all find their hits, then all hits are lit, by one
//! light after the other, and then all rays are reflected. So neighbours can traverse the tree
//! together, also to a light and behind a mirror. (Laine, Karras and Aila, Megakernels Considered Harmful, 2013:
//! wavefronts.)

mod batch;
mod lighting;
mod mirror_directions;
mod offset_ray;

use common::steps::{self, StepKind};
use common::{Color, Omission, Omissions};
use fearless_simd::prelude::*;

use crate::accel::{Accelerator, NearestHits, PACKETS, Query};
use crate::lanes::{ColorPacket, RayPacket, bits, mask};
use crate::shade::RadianceBound;
use crate::{Light, Surface};
pub(crate) use batch::Batch;
use batch::{Path, Vertex};
use mirror_directions::mirror_directions;
use offset_ray::offset_rays;

/// Rays of a batch, at most.
pub(crate) const BATCH: usize = 4 * PACKETS;

/// A scene that is ready for rays.
pub(crate) struct Tracer<'a> {
    pub background: Color,
    pub ambient: Color,
    /// Largest number of surfaces that a path meets.
    pub depth: u32,
    pub accelerator: Accelerator<'a>,
    pub surfaces: Vec<Surface<'a>>,
    pub lights: Vec<Light<'a>>,
    /// Ends paths with a throughput below a threshold, where the picture may have an error.
    pub cutoff: Option<RadianceBound>,
    /// The work that is left out.
    pub omissions: Omissions,
}

impl Tracer<'_> {
    /// Whether this work is left out.
    #[inline]
    fn omits(&self, omission: Omission) -> bool {
        self.omissions.contains(omission)
    }

    /// The light along the first rays of some packets, one for each element of `light`;
    /// fastest if they are neighbours.
    #[inline(always)]
    pub fn trace<S: Simd>(
        &self,
        packets: &[RayPacket<S>],
        light: &mut [Color],
        batch: &mut Batch<S>,
    ) {
        for (packets, light) in packets.chunks(BATCH / 4).zip(light.chunks_mut(BATCH)) {
            self.trace_batch(packets, light, batch);
        }
    }

    #[inline(always)]
    fn trace_batch<S: Simd>(
        &self,
        rays: &[RayPacket<S>],
        light: &mut [Color],
        batch: &mut Batch<S>,
    ) {
        batch.start(rays, light.len(), self.lights.len());
        for bounce in 0..self.depth {
            let active = batch.active();
            if active == 0 {
                break;
            }
            if bounce > 0 {
                steps::count(StepKind::ReflectedRay, active);
            }
            self.find_vertices(batch);
            self.light(batch);
            for vertex in &batch.vertices {
                self.reflect(&mut batch.paths[vertex.path], vertex);
            }
        }
        for (path, light) in batch.paths.iter().zip(light.chunks_mut(4)) {
            for (light, color) in light.iter_mut().zip(path.color.to_lanes()) {
                *light = color;
            }
        }
    }

    /// Finds the vertices of the active paths, and adds the background to rays without a hit.
    #[inline(always)]
    fn find_vertices<S: Simd>(&self, batch: &mut Batch<S>) {
        let simd = batch.simd;
        let Batch {
            paths,
            queries,
            vertices,
            ..
        } = batch;
        let active = paths.iter().filter(|path| path.active != 0);
        queries.clear();
        queries.extend(active.map(|path| Query::nearest(&path.rays, path.active)));
        self.accelerator.traverse(queries, &mut None);

        let background = ColorPacket::splat(simd, self.background);
        let paths = paths.iter_mut().enumerate();
        let active = paths.filter(|(_, path)| path.active != 0);
        vertices.clear();
        for ((i, path), query) in active.zip(queries) {
            let hit_mask = query.hit_mask();
            let missed = path.active & !hit_mask;
            if missed != 0 {
                path.color = path.color + (path.throughput * background).masked(mask(simd, missed));
            }
            path.active = hit_mask;
            if hit_mask != 0 {
                vertices.push(self.vertex(i, &self.accelerator.shapes.hits(query)));
            }
        }
    }

    /// Adds the light that the surfaces scatter to the path, and reflects its rays.
    #[inline(always)]
    fn reflect<S: Simd>(&self, path: &mut Path<S>, Vertex { hits, color, .. }: &Vertex<S>) {
        let active = mask(path.rays.simd(), path.active);
        path.color = path.color + (path.throughput * *color).masked(active);
        path.throughput = path.throughput * self.reflectance(hits);
        path.active &= !self.terminated(path.throughput, path.active);
        if path.active != 0 {
            let direction = mirror_directions(&path.rays, &hits.hit);
            path.rays = offset_rays(&path.rays, &hits.hit, direction);
        }
    }

    /// The reflectances of the surfaces.
    #[inline(always)]
    fn reflectance<S: Simd>(&self, hits: &NearestHits<S>) -> ColorPacket<S> {
        let simd = hits.hit.t.simd;
        let reflectance = |index: u32| self.surfaces[index as usize].reflection;
        if hits.is_one_surface() {
            return ColorPacket::splat(simd, reflectance(hits.surfaces[0]));
        }
        ColorPacket::new(simd, hits.surfaces.map(reflectance))
    }

    /// A bit for each active ray with a throughput so low that it is not followed further.
    #[inline(always)]
    fn terminated<S: Simd>(&self, throughput: ColorPacket<S>, active: u32) -> u32 {
        let mut terminated = 0;
        if self.omits(Omission::BlackMirrors) {
            terminated = throughput.are_black();
        }
        if let Some(cutoff) = self.cutoff
            && self.omits(Omission::FaintReflections)
        {
            let throughput = throughput.to_lanes();
            for lane in bits(active) {
                terminated |= u32::from(cutoff.cuts(throughput[lane])) << lane;
            }
        }
        terminated
    }
}
