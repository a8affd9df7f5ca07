//! `Camera`: computes the rays through positions in a picture.

use common::Size;
use fearless_simd::prelude::*;
use glam::DVec3;

use crate::Ray;
use crate::lanes::{RayPacket, Vector3x4, in_fours, lanes, splat};
use crate::vector::normalized;

/// The ray through the position (x, y) in a picture of this size: whole numbers are the
/// middles of pixels, and y counts upwards.
pub type RayFn<'a> = Box<dyn Fn(Size, f64, f64) -> Ray + Send + Sync + 'a>;

/// A camera.
pub enum Camera<'a> {
    /// All rays start in the eye.
    Perspective {
        /// Where the camera stands and how it is held.
        basis: Basis,
        /// The tangent of half the vertical field of view.
        half_tangent: f64,
    },
    /// All rays are parallel.
    Orthographic {
        /// Where the camera stands and how it is held.
        basis: Basis,
        /// The height of the picture, from pixel middle to pixel middle.
        scale: f64,
    },
    /// A camera that the engine does not know: each ray comes from this function.
    Other(RayFn<'a>),
}

/// An eye and three axes of length 1, perpendicular to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// The position of the eye.
    pub e: DVec3,
    /// To the right of the picture.
    pub u: DVec3,
    /// Up in the picture.
    pub v: DVec3,
    /// Against the viewing direction.
    pub w: DVec3,
}

impl Camera<'_> {
    /// Adds a packet for each four positions to `packets`. In the last packet the last position
    /// repeats.
    #[inline(always)]
    pub(crate) fn rays<S: Simd>(
        &self,
        simd: S,
        size: Size,
        positions: &[(f64, f64)],
        packets: &mut Vec<RayPacket<S>>,
    ) {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let fours = in_fours(positions);
        match self {
            Self::Perspective {
                basis,
                half_tangent,
            } => {
                let middle = ((width - 1.0) / 2.0, (height - 1.0) / 2.0);
                let z = (height / 2.0) / half_tangent;
                packets.extend(fours.map(|four| basis.perspective_rays(simd, middle, z, four)));
            }
            Self::Orthographic { basis, scale } => {
                let aspect = width / height;
                let ray = |(x, y)| {
                    let right = aspect * scale * from_middle(x, width);
                    let up = scale * from_middle(y, height);
                    Ray {
                        origin: basis.e + basis.u * right + basis.v * up,
                        direction: -basis.w,
                    }
                };
                packets.extend(fours.map(|four| RayPacket::new(simd, four.map(ray).each_ref())));
            }
            Self::Other(ray_for) => {
                let ray = |(x, y)| ray_for(size, x, y);
                packets.extend(fours.map(|four| RayPacket::new(simd, four.map(ray).each_ref())));
            }
        }
    }
}

/// The offset of pixel `p` of `n` from the middle of the picture, relative to its extent.
fn from_middle(p: f64, n: f64) -> f64 {
    (p - (n - 1.0) / 2.0) / (n - 1.0).max(1.0)
}

impl Basis {
    /// The rays from the eye through four positions in a picture with this middle, at the
    /// distance `z`.
    #[inline(always)]
    fn perspective_rays<S: Simd>(
        &self,
        simd: S,
        (middle_x, middle_y): (f64, f64),
        z: f64,
        positions: [(f64, f64); 4],
    ) -> RayPacket<S> {
        let [u, v, w] = [self.u, self.v, self.w].map(|axis| Vector3x4::splat(simd, axis));
        let x = lanes(simd, positions.map(|(x, _)| x)) - middle_x;
        let y = lanes(simd, positions.map(|(_, y)| y)) - middle_y;
        let (mut direction, is_unit) = (u * x + v * y - w * splat(simd, z)).normalized();
        if !is_unit.all_true() {
            let one = |(x, y)| self.direction(x - middle_x, y - middle_y, z);
            direction = Vector3x4::new(simd, positions.map(one));
        }
        RayPacket {
            origin: Vector3x4::splat(simd, self.e),
            direction,
        }
    }

    /// The direction `x u + y v - z w` of length 1.
    fn direction(&self, x: f64, y: f64, z: f64) -> DVec3 {
        normalized(self.u * x + self.v * y - self.w * z).unwrap_or(-self.w)
    }
}
