//! The numbers of the shapes, for the laboratory.

use a02_math::{Normal3, Point3};

use crate::{AxisAlignedBox, Plane, Sphere, Triangle};

impl AxisAlignedBox {
    /// The left, bottom, far corner and the right, upper, near one.
    #[must_use]
    pub const fn opposite_corners(&self) -> [[f64; 3]; 2] {
        [self.lbf, self.run]
    }
}

impl Plane {
    /// The point and the normal of length 1.
    #[must_use]
    pub const fn point_and_normal(&self) -> (Point3, Normal3) {
        (self.a, self.n)
    }
}

impl Sphere {
    /// The centre and the radius.
    #[must_use]
    pub const fn center_and_radius(&self) -> (Point3, f64) {
        (self.c, self.r)
    }
}

impl Triangle {
    /// The corners.
    #[must_use]
    pub const fn corners(&self) -> [Point3; 3] {
        self.corners
    }
}
