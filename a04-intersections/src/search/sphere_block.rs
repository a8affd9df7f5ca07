//! `SphereBlock`: four spheres side by side, which one instruction serves.

use a03_rays_cameras::Ray;
use wide::f64x4;

use super::shapes::{Shape, Shapes};
use super::tree::WIDTH;
use crate::Sphere;

/// Up to four spheres, and which these are.
#[derive(Debug)]
pub struct SphereBlock {
    c: [f64x4; 3],
    r: f64x4,
    pub spheres: [u32; WIDTH],
}

/// A ray, four times side by side.
pub struct SphereRay {
    o: [f64x4; 3],
    d: [f64x4; 3],
    a: f64x4,
}

impl SphereRay {
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
        Self {
            o: [f64x4::splat(o.x), f64x4::splat(o.y), f64x4::splat(o.z)],
            d: [f64x4::splat(d.x), f64x4::splat(d.y), f64x4::splat(d.z)],
            a: f64x4::splat(d.dot(d)),
        }
    }
}

impl SphereBlock {
    pub fn new(shapes: &Shapes, block: &[Shape]) -> Self {
        let index = |lane: usize| match block.get(lane) {
            Some(Shape::Sphere(index)) => *index,
            _ => u32::MAX,
        };
        let lanes = |value: &dyn Fn(&Sphere) -> f64| {
            // No ray has a discriminant with a missing sphere.
            let sphere = |lane| shapes.spheres.get(index(lane) as usize);
            let lane = |lane| sphere(lane).map_or(f64::NAN, |(sphere, _)| value(sphere));
            f64x4::new(std::array::from_fn(lane))
        };
        Self {
            c: [0, 1, 2].map(|axis| lanes(&|sphere| sphere.c.to_glam()[axis])),
            r: lanes(&|sphere| sphere.r),
            spheres: std::array::from_fn(index),
        }
    }

    /// A bit for each sphere whose discriminant is not negative: the same
    /// operations in the same order as in [`Sphere`], so that both agree.
    #[inline]
    pub fn met(&self, ray: &SphereRay) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (ray.o, ray.d, self.c);
        let (fx, fy, fz) = (ox - cx, oy - cy, oz - cz);
        let middle = -(fx * dx + fy * dy + fz * dz) / ray.a;
        let (lx, ly, lz) = (fx + dx * middle, fy + dy * middle, fz + dz * middle);
        let discriminant = self.r * self.r - (lx * lx + ly * ly + lz * lz);
        discriminant.simd_ge(f64x4::ZERO).to_bitmask()
    }
}
