//! Tracing many rays together: each is followed as `RecursiveTracer::trace` does,
//! and brings back the same colour, to the last bit.
//!
//! Four rays at a time go from mirror to mirror, until none of them goes on.

use a02_math::vector3x4::mask;
use a02_math::{Lanes, Normal3, Vector3x4};
use a03_rays_cameras::{Radiance, Ray, RayPacket};
use a04_intersections::{Hit, Hits, Search};
use a05_lighting::{ColorPacket, Light, Lighting, Material, PhongPacket};
use common::Color;
use measure::tally::{self, Work};

use crate::secondary_ray::secondary_rays;
use crate::shadow::BEFORE_THE_LIGHT;
use crate::{RecursiveTracer, Surface};

/// The light along rays that may meet so many surfaces.
#[derive(Clone, Copy, Debug)]
pub struct TracedLight<'a> {
    /// Who follows them.
    pub tracer: RecursiveTracer<'a>,
    /// How many surfaces each may meet.
    pub depth: u32,
}

impl Radiance for TracedLight<'_> {
    fn along(&self, rays: &[Ray], light: &mut [Color]) {
        self.tracer.trace_together(rays, self.depth, light);
    }

    /// What is only seen in a mirror, or is a shadow, is not thought of.
    fn may_hide(&self, corners: &[Ray; 4], narrow: f64) -> bool {
        let search = self.tracer.search();
        search.is_none_or(|search| search.may_hide(corners, narrow))
    }
}

impl RecursiveTracer<'_> {
    /// The prepared world, if work may be left out.
    fn search(&self) -> Option<&Search> {
        self.world().objects().search().filter(|_| self.omits())
    }

    /// The colours that rays bring back which may meet `depth` surfaces, for
    /// `colors`: as many as there are rays.
    ///
    /// Four are traced together if the world is [prepared](a05_lighting::LitWorld)
    /// and work may be left out, the fastest if they are neighbours.
    pub fn trace_together(&self, rays: &[Ray], depth: u32, colors: &mut [Color]) {
        let Some(search) = self.search() else {
            for (ray, color) in rays.iter().zip(colors) {
                *color = self.trace(ray, depth);
            }
            return;
        };
        let (fours, rest) = rays.as_chunks();
        let (colors_of_fours, colors_of_rest) = colors.as_chunks_mut();
        for (four, colors) in fours.iter().zip(colors_of_fours) {
            let packet = RayPacket::new(four.each_ref());
            *colors = self.trace_four(search, packet, 0b1111, depth).to_lanes();
        }
        if let [alone] = rest {
            colors_of_rest[0] = self.trace(alone, depth);
        } else if let [first, ..] = rest {
            let ray = |lane: usize| rest.get(lane).unwrap_or(first);
            let packet = RayPacket::new([ray(0), ray(1), ray(2), ray(3)]);
            let active = (1 << rest.len()) - 1;
            let four = self.trace_four(search, packet, active, depth).to_lanes();
            colors_of_rest.copy_from_slice(&four[..rest.len()]);
        }
    }

    /// The colours that those of four rays bring back whose bits are set in
    /// `active`.
    // ANCHOR: trace-four
    fn trace_four(
        &self,
        search: &Search,
        mut rays: RayPacket,
        mut active: u32,
        depth: u32,
    ) -> ColorPacket {
        let background = ColorPacket::splat(self.world().objects().background());
        let mut color = ColorPacket::splat(Color::BLACK);
        let mut mirrored = ColorPacket::splat(Color::WHITE);
        for met in 0..depth {
            if met > 0 {
                tally::count_all(Work::ReflectedRay, active.count_ones().into());
            }
            let hits = search.hit_together(&rays, active);
            let missed = active & !hits.met;
            if missed != 0 {
                color = color + (mirrored * background).masked(mask(missed));
            }
            active = hits.met;
            if active == 0 {
                break;
            }
            let (seen, reflection) = self.look(search, &rays, &hits);
            color = color + (mirrored * seen).masked(mask(active));
            mirrored = mirrored * reflection;
            active &= !self.ends(mirrored, active);
            if active == 0 {
                break;
            }
            let direction = (-rays.direction).reflected_on(hits.hit.normal);
            rays = secondary_rays(&rays, &hits.hit, direction);
        }
        color
    }
    // ANCHOR_END: trace-four

    /// A bit for each ray of those in `active` whose light is not followed further.
    #[inline]
    fn ends(&self, mirrored: ColorPacket, active: u32) -> u32 {
        let mut ends = mirrored.are_black();
        if let Some(cut) = self.cut() {
            let mirrored = mirrored.to_lanes();
            for lane in (0..4).filter(|lane| active >> lane & 1 != 0) {
                ends |= u32::from(cut.is_due(mirrored[lane])) << lane;
            }
        }
        ends
    }

    /// What the surfaces make of the light, and which share they mirror.
    #[inline]
    fn look(&self, search: &Search, rays: &RayPacket, hits: &Hits) -> (ColorPacket, ColorPacket) {
        let surface = |object: u32| &**self.world().objects().surface(object as usize);
        let [a, b, c, d] = hits.objects;
        if a == b && a == c && a == d {
            let surface = surface(a);
            let seen = match surface.as_phong() {
                Some(phong) => self.shade(search, rays, hits, &PhongPacket::splat(&phong)),
                None => self.shade_one_by_one(rays, hits, [surface; 4]),
            };
            return (seen, ColorPacket::splat(surface.reflection()));
        }
        let surfaces = hits.objects.map(surface);
        let seen = match surfaces.map(Material::as_phong) {
            [Some(a), Some(b), Some(c), Some(d)] => {
                let phong = PhongPacket::new([a, b, c, d]);
                self.shade(search, rays, hits, &phong)
            }
            _ => self.shade_one_by_one(rays, hits, surfaces),
        };
        (seen, ColorPacket::new(surfaces.map(Surface::reflection)))
    }

    /// What materials make of the light that only say so for one ray.
    #[inline(never)]
    fn shade_one_by_one(
        &self,
        rays: &RayPacket,
        hits: &Hits,
        surfaces: [&dyn Surface; 4],
    ) -> ColorPacket {
        let rays = rays.to_rays();
        let t = hits.hit.t.to_array();
        let [normals, faces] = [hits.hit.normal, hits.hit.face].map(Vector3x4::to_lanes);
        ColorPacket::new([0, 1, 2, 3].map(|lane| {
            if hits.met >> lane & 1 == 0 {
                return Color::BLACK;
            }
            let hit = Hit {
                t: t[lane],
                normal: Normal3::from_glam(normals[lane]),
                face: Normal3::from_glam(faces[lane]),
            };
            surfaces[lane].color_for(&rays[lane], &hit, self)
        }))
    }

    /// What the materials make of the light.
    #[inline]
    fn shade(
        &self,
        search: &Search,
        rays: &RayPacket,
        hits: &Hits,
        phong: &PhongPacket,
    ) -> ColorPacket {
        let world = self.world();
        let mut color = phong.ambient(world.ambient());
        let answering = phong.answer_light() & hits.met;
        let points = rays.at(hits.hit.t);
        for source in world.lights() {
            if answering == 0 {
                break;
            }
            let light = source.illuminations(points, answering);
            let facing = hits.hit.normal.dot(light.direction).simd_gt(Lanes::ZERO);
            let mut lit = light.lit & facing.to_bitmask();
            if source.casts_shadows() && lit != 0 {
                tally::count_all(Work::ShadowRay, lit.count_ones().into());
                let to_light = secondary_rays(rays, &hits.hit, light.direction);
                let before = light.distance * Lanes::splat(BEFORE_THE_LIGHT);
                lit &= !search.is_hit_together(&to_light, before, lit);
            }
            if lit != 0 {
                color = color + phong.shade(rays.direction, hits.hit.normal, &light, lit);
            }
        }
        color
    }
}
