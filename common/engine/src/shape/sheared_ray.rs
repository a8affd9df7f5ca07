//! `ShearedRay` and `ShearedRays`: rays about to be tested against triangles.
//!
//! Space is sheared so that the ray is the z axis, and z measured in `t`. (Woop,
//! Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use glam::DVec3;

use crate::Ray;
use crate::lanes::{Lanes, RayPacket, is_set};

/// A sheared ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRay {
    /// The axes x, y and z of the sheared space; the ray goes farthest along z.
    pub axes: [usize; 3],
    /// The origin along these axes.
    pub origin: [f64; 3],
    pub shear: [f64; 2],
    scale_z: f64,
}

impl ShearedRay {
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let z = d.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (o, d) = (ray.origin.to_array(), d.to_array());
        Self {
            axes: [x, y, z],
            origin: [o[x], o[y], o[z]],
            shear: [d[x] / d[z], d[y] / d[z]],
            scale_z: 1.0 / d[z],
        }
    }

    /// A point in sheared space.
    #[inline]
    pub fn sheared(&self, point: DVec3) -> [f64; 3] {
        let ([x, y, z], point) = (self.axes, point.to_array());
        let depth = point[z] - self.origin[2];
        [
            (point[x] - self.origin[0]) - self.shear[0] * depth,
            (point[y] - self.origin[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
}

/// Four rays sheared along the same axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRays {
    axes: [usize; 3],
    origin: [Lanes; 3],
    shear: [Lanes; 2],
    scale_z: Lanes,
}

impl ShearedRays {
    /// The rays whose bits are set in `active`. None if they do not go farthest along
    /// the same axis.
    #[inline]
    pub fn new(rays: &RayPacket, active: u32) -> Option<Self> {
        let rays = rays.to_rays().map(|ray| ShearedRay::new(&ray));
        let axes = rays[active.trailing_zeros() as usize % 4].axes;
        let is_like_them = |lane: usize| !is_set(active, lane) || rays[lane].axes == axes;
        (0..4).all(is_like_them).then(|| Self {
            axes,
            origin: [0, 1, 2].map(|axis| Lanes::new(rays.map(|ray| ray.origin[axis]))),
            shear: [0, 1].map(|axis| Lanes::new(rays.map(|ray| ray.shear[axis]))),
            scale_z: Lanes::new(rays.map(|ray| ray.scale_z)),
        })
    }

    /// A point in the sheared space of each ray.
    #[inline]
    pub fn sheared(&self, corner: DVec3) -> [Lanes; 3] {
        let corner = corner.to_array();
        let [x, y, z] = self.axes.map(|axis| Lanes::splat(corner[axis]));
        let depth = z - self.origin[2];
        [
            (x - self.origin[0]) - self.shear[0] * depth,
            (y - self.origin[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
}
