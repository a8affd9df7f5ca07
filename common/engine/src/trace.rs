//! `Tracer`: follows four rays at a time from mirror to mirror, until none goes on.

mod offset_ray;

use common::Color;
use measure::tally::{self, Work};

use crate::accel::{Accelerator, Leaf, NearestHits, Occluder};
use crate::lanes::{ColorPacket, Lanes, RayPacket, is_set, mask};
use crate::shade::{PhongPacket, RadianceBound};
use crate::{Light, Phong, Shading, Surface};
use offset_ray::offset_rays;

/// Objects cast a shadow on this share of the way to a light: a lamp may be fixed to an
/// object, which must not keep its light away.
const BEFORE_THE_LIGHT: f64 = 1.0 - 1.0 / 16_777_216.0;

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

/// A surface that sends back no light, for lanes that are shaded otherwise.
const BLACK: Phong = Phong {
    diffuse: Color::BLACK,
    specular: Color::BLACK,
    exponent: 0.0,
};

impl Tracer<'_> {
    /// The light along the rays of some packets, as many as there are elements of `light`;
    /// the fastest if they are neighbours.
    pub fn trace(&self, packets: &[RayPacket], light: &mut [Color]) {
        let mut occluders = vec![None; self.lights.len()];
        let near = self.accelerator.near(packets);
        for (packet, light) in packets.iter().zip(light.chunks_mut(4)) {
            let active = (1 << light.len()) - 1;
            let four = self.trace_packet(*packet, active, near.as_deref(), &mut occluders);
            light.copy_from_slice(&four.to_lanes()[..light.len()]);
        }
    }

    /// The light along the active of four rays. `near` are the only shapes that they may meet
    /// before they are mirrored, if these are known.
    // ANCHOR: trace-packet
    fn trace_packet(
        &self,
        mut rays: RayPacket,
        mut active: u32,
        mut near: Option<&[Leaf]>,
        occluders: &mut [Occluder],
    ) -> ColorPacket {
        let background = ColorPacket::splat(self.background);
        let mut color = ColorPacket::splat(Color::BLACK);
        let mut mirrored = ColorPacket::splat(Color::WHITE);
        for bounce in 0..self.depth {
            if bounce > 0 {
                tally::count_all(Work::ReflectedRay, active.count_ones().into());
            }
            let hits = self.accelerator.hit_packet(&rays, active, near.take());
            let missed = active & !hits.hit_mask;
            if missed != 0 {
                color = color + (mirrored * background).masked(mask(missed));
            }
            active = hits.hit_mask;
            if active == 0 {
                break;
            }
            let (own, reflection) = self.shade(&rays, &hits, occluders);
            color = color + (mirrored * own).masked(mask(active));
            mirrored = mirrored * reflection;
            active &= !self.ends(mirrored, active);
            if active == 0 {
                break;
            }
            let direction = (-rays.direction).reflected_on(hits.hit.normal);
            rays = offset_rays(&rays, &hits.hit, direction);
        }
        color
    }
    // ANCHOR_END: trace-packet

    /// A bit for each active ray that is not followed further.
    #[inline]
    fn ends(&self, mirrored: ColorPacket, active: u32) -> u32 {
        let mut ends = mirrored.are_black();
        if let Some(cutoff) = self.cutoff {
            let mirrored = mirrored.to_lanes();
            for lane in (0..4).filter(|lane| is_set(active, *lane)) {
                ends |= u32::from(cutoff.cuts(mirrored[lane])) << lane;
            }
        }
        ends
    }

    /// The own light of the surfaces, and the share that they mirror.
    #[inline]
    fn shade(
        &self,
        rays: &RayPacket,
        hits: &NearestHits,
        occluders: &mut [Occluder],
    ) -> (ColorPacket, ColorPacket) {
        let surface = |index: u32| &self.surfaces[index as usize];
        let [a, b, c, d] = hits.surfaces;
        if a == b && a == c && a == d {
            let surface = surface(a);
            let reflection = ColorPacket::splat(surface.reflection);
            if let Shading::Phong(phong) = &surface.shading {
                let own = self.shade_phong(rays, hits, &PhongPacket::splat(phong), occluders);
                return (own, reflection);
            }
            return (
                self.shade_mixed(rays, hits, [surface; 4], occluders),
                reflection,
            );
        }
        let surfaces = hits.surfaces.map(surface);
        let reflection = ColorPacket::new(surfaces.map(|surface| surface.reflection));
        let own = match surfaces.map(|surface| &surface.shading) {
            [
                Shading::Phong(a),
                Shading::Phong(b),
                Shading::Phong(c),
                Shading::Phong(d),
            ] => self.shade_phong(rays, hits, &PhongPacket::new([a, b, c, d]), occluders),
            _ => self.shade_mixed(rays, hits, surfaces, occluders),
        };
        (own, reflection)
    }

    /// The own light of surfaces that are not all Phong's.
    #[inline(never)]
    fn shade_mixed(
        &self,
        rays: &RayPacket,
        hits: &NearestHits,
        surfaces: [&Surface; 4],
        occluders: &mut [Occluder],
    ) -> ColorPacket {
        let phong = surfaces.map(|surface| match &surface.shading {
            Shading::Phong(phong) => phong,
            _ => &BLACK,
        });
        let mut colors = self
            .shade_phong(rays, hits, &PhongPacket::new(phong), occluders)
            .to_lanes();
        let (rays, of_lanes) = (rays.to_rays(), hits.hit.to_hits());
        for lane in (0..4).filter(|lane| is_set(hits.hit_mask, *lane)) {
            match &surfaces[lane].shading {
                Shading::Phong(_) => {}
                Shading::SingleColor(color) => colors[lane] = *color,
                Shading::Other(color) => colors[lane] = color(&rays[lane], &of_lanes[lane]),
            }
        }
        ColorPacket::new(colors)
    }

    /// The own light of Phong's surfaces: ambient light, and the light of each source
    /// that no object keeps away.
    #[inline]
    fn shade_phong(
        &self,
        rays: &RayPacket,
        hits: &NearestHits,
        phong: &PhongPacket,
        occluders: &mut [Occluder],
    ) -> ColorPacket {
        let hit = &hits.hit;
        let mut color = phong.ambient(self.ambient);
        let responding = phong.responds_to_light & hits.hit_mask;
        let points = rays.at(hit.t);
        for (source, occluder) in self.lights.iter().zip(occluders) {
            if responding == 0 {
                break;
            }
            let light = source.illuminate(points, responding);
            let facing = hit.normal.dot(light.direction).simd_gt(Lanes::ZERO);
            let mut lit = light.lit & facing.to_bitmask();
            if source.casts_shadows && lit != 0 {
                tally::count_all(Work::ShadowRay, lit.count_ones().into());
                let to_light = offset_rays(rays, hit, light.direction);
                let before = light.distance * Lanes::splat(BEFORE_THE_LIGHT);
                lit &= !self
                    .accelerator
                    .is_hit_packet(&to_light, before, lit, occluder);
            }
            if lit != 0 {
                color = color + phong.shade(rays.direction, hit.normal, &light, lit);
            }
        }
        color
    }
}
