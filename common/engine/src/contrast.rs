//! The contrast of a pixel: an upper bound of the difference between the light at any two places
//! of it, which is known before the first ray.
//!
//! A pixel that no shape can reach shows the background, and its contrast is 0. If one convex
//! shape fills a pixel, its light changes by no more than its positions, normals and directions
//! allow. Where several shapes may meet in a pixel, anything may be hidden between two samples:
//! the contrast is infinite, which stands for unknown.

mod footprint;
mod occupancy;
mod separation;
mod shading;

use common::{Color, Size};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::accel::{Kind, ShapeId, Shapes};
use crate::lanes::{Lanes, PacketHit, RayPacket};
use crate::sampler::image_position;
use crate::shape::{Rays, Shape};
use crate::{Camera, Light, Ray, Surface};
use footprint::{Footprint, Spread};
use occupancy::{Occupancy, Occupant};
use separation::is_separated;

/// All four lanes.
const ALL: u32 = 0b1111;
/// The corners of a pixel, in the pixel.
const CORNERS: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];

/// What decides the light in a picture.
#[derive(Clone, Copy)]
pub(crate) struct World<'w, 'a> {
    pub shapes: &'w Shapes<'a>,
    pub surfaces: &'w [Surface<'a>],
    pub lights: &'w [Light<'a>],
    /// Upper bound of the light that any ray brings back.
    pub max_radiance: Color,
    pub camera: &'w Camera<'a>,
}

impl World<'_, '_> {
    /// The contrast of each pixel, row after row; empty if nothing is known.
    pub fn contrasts(&self, size: Size) -> Vec<f32> {
        let Some(occupancy) = Occupancy::new(self.shapes, self.camera, size) else {
            return Vec::new();
        };
        let mut contrasts = Vec::new();
        if contrasts.try_reserve_exact(size.pixels()).is_err() {
            return contrasts;
        }
        contrasts.resize(size.pixels(), f32::INFINITY);
        let rows = contrasts.par_chunks_exact_mut(size.width() as usize);
        rows.enumerate().for_each(|(row, contrasts)| {
            for (column, contrast) in contrasts.iter_mut().enumerate() {
                let pixel = (column as u32, row as u32);
                // Rounding to fewer digits may not make it smaller.
                *contrast = (self.contrast(&occupancy, size, pixel) as f32).next_up();
                if *contrast <= f32::from_bits(1) {
                    *contrast = 0.0;
                }
            }
        });
        contrasts
    }

    /// The contrast of a pixel in this column and row.
    fn contrast(&self, occupancy: &Occupancy, size: Size, pixel: (u32, u32)) -> f64 {
        let bounded = match occupancy.occupant(pixel) {
            Occupant::Several => return f64::INFINITY,
            Occupant::One(shape) => Some(shape),
            Occupant::None if occupancy.planes.is_empty() => return 0.0,
            Occupant::None => None,
        };
        let corners = CORNERS.map(|corner| image_position(size, pixel, corner));
        let mut packets = Vec::with_capacity(1);
        self.camera.rays(size, &corners, &mut packets);
        let rays = Rays::four(&packets[0], ALL);
        let bounded = bounded.filter(|shape| !self.is_beside(*shape, &rays.packet));
        match self.visible(&rays, &occupancy.planes, bounded) {
            Visible::Background => 0.0,
            Visible::Unknown => f64::INFINITY,
            Visible::Shape(shape, t) => self.contrast_on(shape, &rays, t),
        }
    }

    /// Whether a shape is a sphere that no ray of a pixel meets, although its bounds reach there.
    fn is_beside(&self, shape: ShapeId, rays: &RayPacket) -> bool {
        shape.kind == Kind::Sphere && {
            let sphere = &self.shapes.spheres.shapes[shape.index as usize];
            is_separated(sphere, &rays.to_rays())
        }
    }

    /// What fills a pixel, if one thing does, from the rays through its corners.
    ///
    /// In the coordinates of the picture and with the reciprocal of the depth, planes remain planes
    /// and convex shapes remain convex. So a plane that all four rays meet is met by all rays
    /// between them, and a plane that they all miss is missed; a convex shape that all of them meet
    /// fills the pixel; and if it is nearer than a plane in the corners, it is nearer everywhere.
    fn visible(&self, rays: &Rays, planes: &[ShapeId], bounded: Option<ShapeId>) -> Visible {
        let mut visible = Visible::Background;
        for shape in planes.iter().copied().chain(bounded) {
            let t = self.shapes.intersect(shape, rays);
            let hit = t.simd_ge(Lanes::ZERO).to_bitmask();
            if hit == 0 && Some(shape) != bounded {
                continue;
            }
            if hit != ALL || (Some(shape) == bounded && !self.is_convex(shape)) {
                return Visible::Unknown;
            }
            visible = match visible {
                Visible::Shape(_, nearest) if nearest.simd_lt(t).to_bitmask() == ALL => {
                    // A shape behind a plane in the corners may stand out of it between them.
                    if Some(shape) == bounded {
                        return Visible::Unknown;
                    }
                    visible
                }
                Visible::Shape(_, nearest) if t.simd_lt(nearest).to_bitmask() != ALL => {
                    return Visible::Unknown;
                }
                _ => Visible::Shape(shape, t),
            };
        }
        visible
    }

    /// Whether a shape is a convex one whose normals are known.
    fn is_convex(&self, shape: ShapeId) -> bool {
        shape.kind == Kind::Sphere || self.is_flat(shape)
    }

    /// Whether a shape has flat faces.
    fn is_flat(&self, shape: ShapeId) -> bool {
        match shape.kind {
            Kind::Plane | Kind::Disc | Kind::Triangle | Kind::Box => true,
            Kind::Transformed => matches!(
                *self.shapes.transformed.shapes[shape.index as usize].shape,
                Shape::Plane(_) | Shape::Disc(_) | Shape::Triangle(_) | Shape::Box(_)
            ),
            Kind::Sphere | Kind::Other => false,
        }
    }

    /// The contrast of a pixel that a convex shape fills.
    fn contrast_on(&self, shape: ShapeId, rays: &Rays, t: Lanes) -> f64 {
        let hit = self.shapes.hits_on(shape, rays, t);
        let curvature = if self.is_flat(shape) {
            if !is_one_face(&hit) || !is_outside(&hit, &rays.packet) && has_inside(shape) {
                return f64::INFINITY;
            }
            0.0
        } else {
            let sphere = &self.shapes.spheres.shapes[shape.index as usize];
            let spread = Spread::new(&rays.packet);
            // Between the origins in the corners, none may lie inside the sphere either.
            let is_far =
                |ray: &Ray| sphere.center.distance(ray.origin) > sphere.radius + spread.origins;
            if !rays.packet.to_rays().iter().all(is_far) {
                return f64::INFINITY;
            }
            1.0 / sphere.radius
        };
        let footprint = Footprint::new(&rays.packet, &hit.facing(&rays.packet), curvature);
        let surface = &self.surfaces[self.shapes.attributes(shape).surface as usize];
        // A convex shape that is alone casts no shadow on itself, and mirrors the background.
        let is_alone = self.shapes.len() == 1;
        let mut contrast = Color::BLACK;
        if !is_alone && surface.reflection != Color::BLACK {
            contrast += surface.reflection * self.max_radiance;
        }
        contrast += footprint.contrast(&surface.shading, self.lights, is_alone);
        let largest = contrast.largest_channel();
        if contrast.channels().iter().all(|c| c.is_finite()) {
            largest
        } else {
            f64::INFINITY
        }
    }
}

/// Whether rays can start inside of a shape with flat faces.
const fn has_inside(shape: ShapeId) -> bool {
    matches!(shape.kind, Kind::Box | Kind::Transformed)
}

/// What a pixel shows.
#[derive(Clone, Copy)]
enum Visible {
    Background,
    /// One shape, with the positions of the hits of the rays through the corners.
    Shape(ShapeId, Lanes),
    Unknown,
}

/// Whether four hits have the same normals. Interpolated normals that agree in the corners of a
/// pixel agree between them.
fn is_one_face(hit: &PacketHit) -> bool {
    let [first, others @ ..] = hit.to_hits();
    others
        .iter()
        .all(|hit| hit.normal == first.normal && hit.geometric_normal == first.geometric_normal)
}

/// Whether four rays hit a shape from outside.
fn is_outside(hit: &PacketHit, rays: &RayPacket) -> bool {
    let against = hit
        .geometric_normal
        .dot(rays.direction)
        .simd_lt(Lanes::ZERO);
    against.to_bitmask() == ALL
}

#[cfg(test)]
mod tests;
