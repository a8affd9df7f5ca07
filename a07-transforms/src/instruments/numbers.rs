//! The parts of discs and nodes, for the laboratory.

use a02_math::Point3;
use a04_intersections::{Geometry, Plane};

use crate::{Disc, Node};

impl Disc {
    /// The plane of the disc, its centre and its radius.
    #[must_use]
    pub const fn parts(&self) -> (&Plane, Point3, f64) {
        (&self.plane, self.c, self.r)
    }
}

impl Node {
    /// The geometries in the space of the node.
    #[must_use]
    pub fn children(&self) -> &[Box<dyn Geometry>] {
        &self.children
    }
}
