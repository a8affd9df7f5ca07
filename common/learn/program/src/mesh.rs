//! `Mesh`: a shape of triangles, whose hit is the nearest of theirs.

use crate::prelude::*;

#[derive(Debug)]
pub struct Mesh {
    /// The triangles with their numbers.
    triangles: World<usize>,
    count: usize,
}

impl Mesh {
    pub fn new() -> Made<Self> {
        Ok(Self {
            triangles: World::new(Color::BLACK)?,
            count: 0,
        })
    }

    /// This mesh with one more triangle.
    pub fn with(self, triangle: Triangle) -> Self {
        Self {
            triangles: self.triangles.with(triangle, self.count),
            count: self.count + 1,
        }
    }
}

impl Geometry for Mesh {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (hit, _) = nearest(&self.triangles, ray, within)?;
        Some(hit)
    }
}
