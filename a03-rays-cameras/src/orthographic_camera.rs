//! `OrthographicCamera`: parallel rays, so that size does not depend on distance.

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size, argument};

use crate::{Basis, Camera, Ray};

/// A camera whose rays are parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthographicCamera {
    pub(crate) basis: Basis,
    pub(crate) s: f64,
}

impl OrthographicCamera {
    /// A camera at `e` looking along `g` with `t` upwards, whose picture shows
    /// a height of `s` from the middle of its lowest pixel to the middle of its
    /// highest: a length of the scene from 1e-100 to 1e100.
    pub fn new(e: Point3, g: Vector3, t: Vector3, s: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            basis: Basis::new(e, g, t)?,
            s: argument::length("scale s", s)?,
        })
    }

    /// Position and orientation of the camera.
    #[must_use]
    pub const fn basis(&self) -> Basis {
        self.basis
    }
}

/// From `o = e + a s (x - (w-1)/2) / (w-1) u + s (y - (h-1)/2) / (h-1) v`, with
/// the aspect ratio `a = w / h`, in the direction `-w`.
impl Camera for OrthographicCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let Basis { e, u, v, w } = self.basis;
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let a = width / height;
        let right = a * self.s * from_middle(x, width);
        let up = self.s * from_middle(y, height);
        Ray::derived(e + u * right + v * up, -w)
    }
}

// ANCHOR: bracket
/// Offset of pixel `p` of `n` from the middle of the picture, as a fraction of
/// its extent: -1/2 for the first and 1/2 for the last. In a picture one pixel
/// wide the middle of the only pixel is at 0.
fn from_middle(p: f64, n: f64) -> f64 {
    (p - (n - 1.0) / 2.0) / (n - 1.0).max(1.0)
}
// ANCHOR_END: bracket
