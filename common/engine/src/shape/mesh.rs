//! `Mesh`: triangles that share their corners and normals.

use super::pool::Pool;
use super::{Corners, Triangle};
use crate::lanes::{Lanes, Vector3x4};

/// Triangles, whose vectors are stored once.
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    vectors: Pool,
    triangles: Vec<Indexed>,
}

/// A triangle, by the indices of its vectors.
#[derive(Clone, Copy, Debug)]
struct Indexed {
    corners: [u32; 3],
    normals: [u32; 3],
    face: u32,
}

impl Mesh {
    pub fn push(&mut self, triangle: &Triangle) {
        let mut add = |vector| self.vectors.add(vector);
        self.triangles.push(Indexed {
            corners: triangle.corners.map(&mut add),
            normals: triangle.normals.map(&mut add),
            face: add(triangle.face),
        });
    }

    #[inline]
    pub fn get(&self, index: usize) -> Triangle {
        let triangle = &self.triangles[index];
        let vector = |index| self.vectors.get(index);
        Triangle {
            corners: triangle.corners.map(vector),
            normals: triangle.normals.map(vector),
            face: vector(triangle.face),
        }
    }

    /// The corners of a triangle, four times.
    #[inline]
    pub fn corners_of(&self, index: usize) -> Corners {
        self.triangles[index].corners.map(|corner| {
            let corner = self.vectors.get(corner);
            [corner.x, corner.y, corner.z].map(Lanes::splat)
        })
    }

    /// The corners of four triangles side by side.
    #[inline]
    pub fn corners_of_four(&self, [a, b, c, d]: [usize; 4]) -> Corners {
        let four = [a, b, c, d].map(|index| &self.triangles[index].corners);
        [0, 1, 2].map(|corner| {
            let vectors = four.map(|corners| self.vectors.get(corners[corner]));
            let Vector3x4 { x, y, z } = Vector3x4::new(vectors);
            [x, y, z]
        })
    }

    pub fn swap(&mut self, a: usize, b: usize) {
        self.triangles.swap(a, b);
    }

    /// Releases the memory that only `push` needs.
    pub fn finish(&mut self) {
        self.vectors.finish();
        self.triangles.shrink_to_fit();
    }
}
