//! Tracing many rays together: each is followed as `RecursiveTracer::trace` does,
//! and brings back the same colour, to the last bit.
//!
//! Rays are followed four at a time. Those that are mirrored are gathered anew
//! after every bounce, so that none waits for a neighbour that goes on.

use a02_math::{Lanes, Normal3, Vector3x4};
use a03_rays_cameras::{Ray, RayPacket};
use a04_intersections::{Hit, Hits, Search};
use a05_lighting::{Light, Material, PhongPacket};
use common::Color;
use common::tally::{self, Work};

use crate::secondary_ray::secondary_rays;
use crate::shadow::BEFORE_THE_LIGHT;
use crate::{RecursiveTracer, Surface};

/// A ray that is still followed.
#[derive(Clone, Copy)]
struct Path {
    /// Whose colour it adds to.
    index: usize,
    ray: Ray,
    /// The share of its light that reaches the eye.
    mirrored: Color,
}

impl RecursiveTracer<'_> {
    /// The colours that rays bring back which may meet `depth` surfaces.
    pub fn trace_together(&self, rays: &[Ray], depth: u32, colors: &mut [Color]) {
        let search = self.world().objects().search();
        let Some(search) = search.filter(|_| self.can_trace_together()) else {
            for (ray, color) in rays.iter().zip(colors) {
                *color = self.trace(ray, depth);
            }
            return;
        };
        colors.fill(Color::BLACK);
        let paths = rays.iter().enumerate();
        let mut paths: Vec<_> = paths
            .map(|(index, ray)| Path {
                index,
                ray: *ray,
                mirrored: Color::WHITE,
            })
            .collect();
        let mut mirrored = Vec::with_capacity(paths.len());
        for met in 0..depth {
            if met > 0 {
                tally::count_all(Work::ReflectedRay, paths.len() as u64);
            }
            let (fours, rest) = paths.as_chunks();
            for four in fours {
                self.follow(search, four, 0b1111, colors, &mut mirrored);
            }
            if let [first, others @ ..] = rest {
                // The last four are filled up with the first of them.
                let mut four = [*first; 4];
                four[1..rest.len()].copy_from_slice(others);
                let active = (1 << rest.len()) - 1;
                self.follow(search, &four, active, colors, &mut mirrored);
            }
            paths.clear();
            std::mem::swap(&mut paths, &mut mirrored);
        }
    }

    /// Follows up to four rays to where they meet something, and adds what is
    /// mirrored there.
    fn follow(
        &self,
        search: &Search,
        paths: &[Path; 4],
        active: u32,
        colors: &mut [Color],
        mirrored: &mut Vec<Path>,
    ) {
        let [a, b, c, d] = paths;
        let rays = RayPacket::new([&a.ray, &b.ray, &c.ray, &d.ray]);
        let hits = search.hit_together(&rays, active);
        let background = self.world().objects().background();
        for (lane, path) in paths.iter().enumerate() {
            if active & !hits.met & 1 << lane != 0 {
                colors[path.index] += path.mirrored * background;
            }
        }
        if hits.met == 0 {
            return;
        }

        let surface = |object: u32| &**self.world().objects().surface(object as usize);
        let [a, b, c, d] = hits.objects;
        let are_one = a == b && a == c && a == d;
        let (seen, reflections) = if are_one {
            let surface = surface(a);
            let seen = match surface.as_phong() {
                Some(phong) => self.shade(search, &rays, &hits, &PhongPacket::splat(&phong)),
                None => self.shade_one_by_one(&rays, &hits, [surface; 4]),
            };
            (seen, [surface.reflection(); 4])
        } else {
            let surfaces = hits.objects.map(surface);
            let seen = match surfaces.map(Material::as_phong) {
                [Some(a), Some(b), Some(c), Some(d)] => {
                    let phong = PhongPacket::new([a, b, c, d]);
                    self.shade(search, &rays, &hits, &phong)
                }
                _ => self.shade_one_by_one(&rays, &hits, surfaces),
            };
            (seen, surfaces.map(Surface::reflection))
        };
        let mut further = 0;
        let mut shares = [Color::BLACK; 4];
        for (lane, path) in paths.iter().enumerate() {
            if hits.met >> lane & 1 != 0 {
                colors[path.index] += path.mirrored * seen[lane];
                shares[lane] = path.mirrored * reflections[lane];
                further |= u32::from(shares[lane] != Color::BLACK) << lane;
            }
        }
        if further == 0 {
            return;
        }
        let direction = (-rays.direction).reflected_on(hits.hit.normal);
        let rays = secondary_rays(&rays, &hits.hit, direction).to_rays();
        for (lane, path) in paths.iter().enumerate() {
            if further >> lane & 1 != 0 {
                mirrored.push(Path {
                    index: path.index,
                    ray: rays[lane],
                    mirrored: shares[lane],
                });
            }
        }
    }

    /// What materials make of the light that only say so for one ray.
    #[inline(never)]
    fn shade_one_by_one(
        &self,
        rays: &RayPacket,
        hits: &Hits,
        surfaces: [&dyn Surface; 4],
    ) -> [Color; 4] {
        let rays = rays.to_rays();
        let t = hits.hit.t.to_array();
        let [normals, faces] = [hits.hit.normal, hits.hit.face].map(Vector3x4::to_lanes);
        [0, 1, 2, 3].map(|lane| {
            if hits.met >> lane & 1 == 0 {
                return Color::BLACK;
            }
            let hit = Hit {
                t: t[lane],
                normal: Normal3::from_glam(normals[lane]),
                face: Normal3::from_glam(faces[lane]),
            };
            surfaces[lane].color_for(&rays[lane], &hit, self)
        })
    }

    /// What the materials make of the light.
    #[inline]
    fn shade(
        &self,
        search: &Search,
        rays: &RayPacket,
        hits: &Hits,
        phong: &PhongPacket,
    ) -> [Color; 4] {
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
        color.to_lanes()
    }
}
