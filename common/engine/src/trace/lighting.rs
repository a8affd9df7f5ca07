//! The light at the vertices of a batch: ambient light, and the light of each source that no
//! object blocks.

use common::steps::{self, StepKind};
use common::{Color, Omission};
use fearless_simd::prelude::*;

use super::batch::{Batch, Vertex};
use super::{Tracer, offset_rays};
use crate::accel::{NearestHits, Query};
use crate::lanes::{ColorPacket, RayPacket, bits, bits_of};
use crate::shade::{IlluminationPacket, PhongPacket};
use crate::{Phong, Shading};

/// A surface that scatters no light, for lanes that another formula shades.
const BLACK: Phong = Phong {
    diffuse: Color::BLACK,
    specular: Color::BLACK,
    exponent: 0.0,
};

impl Tracer<'_> {
    /// The vertex of a path, under ambient light.
    #[inline(always)]
    pub(super) fn vertex<S: Simd>(&self, path: usize, hits: &NearestHits<S>) -> Vertex<S> {
        let material = self.material(hits);
        Vertex {
            path,
            color: material.ambient(self.ambient),
            material,
            hits: *hits,
        }
    }

    /// Phong's materials of the surfaces; the others are black.
    #[inline(always)]
    fn material<S: Simd>(&self, hits: &NearestHits<S>) -> PhongPacket<S> {
        let simd = hits.hit.t.simd;
        let material = |index| match self.shading(index) {
            Shading::Phong(phong) => phong,
            _ => &BLACK,
        };
        if hits.is_one_surface() {
            return PhongPacket::splat(simd, material(hits.surfaces[0]));
        }
        PhongPacket::new(simd, hits.surfaces.map(material))
    }

    #[inline]
    fn shading(&self, surface: u32) -> &Shading<'_> {
        &self.surfaces[surface as usize].shading
    }

    /// Adds the light of all sources to the vertices.
    #[inline(always)]
    pub(super) fn light<S: Simd>(&self, batch: &mut Batch<S>) {
        for i in 0..self.lights.len() {
            self.light_of(i, batch);
        }
        for vertex in &mut batch.vertices {
            self.shade_others(&batch.paths[vertex.path].rays, vertex);
        }
    }

    /// Adds the light of source `i`.
    #[inline(always)]
    fn light_of<S: Simd>(&self, i: usize, batch: &mut Batch<S>) {
        let source = &self.lights[i];
        let sends_rays = source.casts_shadows || !self.omits(Omission::LightsWithoutShadows);
        let ends_at_first = self.omits(Omission::FartherOccluders);
        let takes_every_power = !self.omits(Omission::UnseenHighlights);
        let Batch {
            paths,
            vertices,
            light,
            queries,
            occluders,
            ..
        } = batch;
        light.clear();
        queries.clear();
        for (at, vertex) in vertices.iter().enumerate() {
            let (rays, hit) = (&paths[vertex.path].rays, &vertex.hits.hit);
            let of_source = source.illuminate(rays.at(hit.t), vertex.hits.hit_mask);
            let mut lit = of_source.lit;
            if self.omits(Omission::UnreflectedLight) {
                lit &= vertex.material.reflects(of_source.color);
            }
            let facing = hit.normal.dot(of_source.direction).simd_gt(0.0);
            if self.omits(Omission::LightsBehind) {
                lit &= bits_of(facing);
            }
            if lit == 0 {
                continue;
            }
            if sends_rays {
                steps::count(StepKind::ShadowRay, lit.count_ones().into());
                let to_light = offset_rays(rays, hit, of_source.direction);
                let offset = hit.rounding_error(rays);
                let distance = of_source.distance;
                queries.push(Query::shadow(
                    &to_light,
                    offset,
                    distance,
                    lit,
                    ends_at_first,
                ));
            }
            // Copied field by field: as a whole, it would be moved by a call.
            light.push((at, IlluminationPacket { lit, ..of_source }));
        }
        self.accelerator.traverse(queries, &mut occluders[i]);
        if source.casts_shadows {
            for ((_, light), query) in light.iter_mut().zip(queries) {
                light.lit &= !query.hit_mask();
            }
        }
        for (at, light) in light {
            let vertex = &mut vertices[*at];
            if light.lit != 0 {
                let (direction, normal) =
                    (paths[vertex.path].rays.direction, vertex.hits.hit.normal);
                let material = &vertex.material;
                let shaded = material.shade(direction, normal, light, takes_every_power);
                vertex.color = vertex.color + shaded;
            }
        }
    }

    /// Replaces the light of surfaces that are not Phong's.
    #[inline(always)]
    fn shade_others<S: Simd>(&self, rays: &RayPacket<S>, vertex: &mut Vertex<S>) {
        let simd = rays.simd();
        let hits = &vertex.hits;
        let is_phong = |surface: &u32| matches!(self.shading(*surface), Shading::Phong(_));
        if hits.surfaces.iter().all(is_phong) {
            return;
        }
        let mut colors = vertex.color.to_lanes();
        let (rays, of_lanes) = (rays.to_rays(), hits.hit.to_hits());
        for lane in bits(hits.hit_mask) {
            match self.shading(hits.surfaces[lane]) {
                Shading::Phong(_) => {}
                Shading::SingleColor(color) => colors[lane] = *color,
                Shading::Other(color) => colors[lane] = color(&rays[lane], &of_lanes[lane]),
            }
        }
        vertex.color = ColorPacket::new(simd, colors);
    }
}
