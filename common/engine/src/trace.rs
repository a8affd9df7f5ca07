//! `Tracer`: follows the rays of a batch from mirror to mirror, until none goes on.
//!
//! All rays take each step together: first all find their hits, then all hits their light, one
//! source after the other, and then all are mirrored. So neighbours can share a search, to a
//! lamp and behind a mirror, too. (Laine, Karras and Aila, Megakernels Considered Harmful, 2013:
//! wavefronts.)

mod batch;
mod lighting;
mod offset_ray;

use common::Color;
use common::tally::{self, Work};

use crate::accel::{Accelerator, NearestHits, NearestSearch, SEARCHES};
use crate::lanes::{ColorPacket, RayPacket, bits, mask};
use crate::shade::RadianceBound;
use crate::{Light, Surface};
pub(crate) use batch::Batch;
use batch::{Path, Vertex};
use offset_ray::offset_rays;

/// Rays of a batch, at most.
pub(crate) const BATCH: usize = 4 * SEARCHES;

/// A scene that is ready for rays.
#[derive(Debug)]
pub(crate) struct Tracer<'a> {
    pub background: Color,
    pub ambient: Color,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    pub accelerator: Accelerator<'a>,
    pub surfaces: Vec<Surface<'a>>,
    pub lights: Vec<Light<'a>>,
    /// Ends rays whose light is below a threshold, where the picture may have an error.
    pub cutoff: Option<RadianceBound>,
}

impl Tracer<'_> {
    /// The light along the rays of some packets, as many as there are elements of `light`;
    /// the fastest if they are neighbours.
    pub fn trace(&self, packets: &[RayPacket], light: &mut [Color], batch: &mut Batch) {
        for (packets, light) in packets.chunks(BATCH / 4).zip(light.chunks_mut(BATCH)) {
            self.trace_batch(packets, light, batch);
        }
    }

    // ANCHOR: trace-batch
    fn trace_batch(&self, rays: &[RayPacket], light: &mut [Color], batch: &mut Batch) {
        batch.start(rays, light.len(), self.lights.len());
        for bounce in 0..self.depth {
            let active = batch.active();
            if active == 0 {
                break;
            }
            if bounce > 0 {
                tally::count_all(Work::ReflectedRay, active);
            }
            self.find_vertices(batch);
            self.light(batch);
            for vertex in &batch.vertices {
                self.mirror(&mut batch.paths[vertex.path], vertex);
            }
        }
        for (path, light) in batch.paths.iter().zip(light.chunks_mut(4)) {
            light.copy_from_slice(&path.color.to_lanes()[..light.len()]);
        }
    }
    // ANCHOR_END: trace-batch

    /// Finds the vertices of the paths that go on, and adds the background to those that end.
    fn find_vertices(&self, batch: &mut Batch) {
        let Batch {
            paths,
            nearest,
            vertices,
            ..
        } = batch;
        let going = paths.iter().filter(|path| path.active != 0);
        nearest.clear();
        nearest.extend(going.map(|path| NearestSearch::new(&path.rays, path.active)));
        self.accelerator.search(nearest, &mut ());

        let background = ColorPacket::splat(self.background);
        let going = paths.iter_mut().enumerate();
        let going = going.filter(|(_, path)| path.active != 0);
        vertices.clear();
        for ((i, path), search) in going.zip(nearest) {
            let hit_mask = search.hit_mask();
            let missed = path.active & !hit_mask;
            if missed != 0 {
                path.color = path.color + (path.mirrored * background).masked(mask(missed));
            }
            path.active = hit_mask;
            if hit_mask != 0 {
                vertices.push(self.vertex(i, self.accelerator.hits(search)));
            }
        }
    }

    /// Adds the own light of the surfaces to the path, and mirrors its rays.
    fn mirror(&self, path: &mut Path, Vertex { hits, color, .. }: &Vertex) {
        path.color = path.color + (path.mirrored * *color).masked(mask(path.active));
        path.mirrored = path.mirrored * self.reflection(hits);
        path.active &= !self.ends(path.mirrored, path.active);
        if path.active != 0 {
            let direction = (-path.rays.direction).reflected_on(hits.hit.normal);
            path.rays = offset_rays(&path.rays, &hits.hit, direction);
        }
    }

    /// The share of light that the surfaces mirror.
    #[inline]
    fn reflection(&self, hits: &NearestHits) -> ColorPacket {
        let reflection = |index: u32| self.surfaces[index as usize].reflection;
        if hits.is_one_surface() {
            return ColorPacket::splat(reflection(hits.surfaces[0]));
        }
        ColorPacket::new(hits.surfaces.map(reflection))
    }

    /// A bit for each active ray that is not followed further.
    #[inline]
    fn ends(&self, mirrored: ColorPacket, active: u32) -> u32 {
        let mut ends = mirrored.are_black();
        if let Some(cutoff) = self.cutoff {
            let mirrored = mirrored.to_lanes();
            for lane in bits(active) {
                ends |= u32::from(cutoff.cuts(mirrored[lane])) << lane;
            }
        }
        ends
    }
}
