//! `Mesh`: triangles that share their normals.

use glam::DVec3;

use super::pool::Pool;
use super::{Corners, List, Triangle};
use crate::lanes::{Simd, Vector3x4, lanes, transposed};

/// Triangles. Each normal is stored once, but corners as often as they are shared: most tests
/// read nothing else, and the four triangles of a leaf lie side by side.
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    corners: Vec<[DVec3; 3]>,
    faces: Vec<Face>,
    vectors: Pool,
}

/// The shading normals and the geometric one of a triangle, by their indices, and its scale.
#[derive(Clone, Copy, Debug)]
struct Face {
    normals: [u32; 3],
    normal: u32,
    scale: f64,
}

impl Mesh {
    pub fn push(&mut self, triangle: &Triangle) {
        let mut add = |vector| self.vectors.add(vector);
        self.faces.push(Face {
            normals: triangle.normals.map(&mut add),
            normal: add(triangle.geometric_normal),
            scale: triangle.scale,
        });
        self.corners.push(triangle.corners);
    }

    /// Releases the memory that only `push` needs.
    pub fn finish(&mut self) {
        self.vectors.finish();
        self.corners.shrink_to_fit();
        self.faces.shrink_to_fit();
    }
}

impl List for Mesh {
    type Shape<'s> = Triangle;

    #[inline]
    fn get(&self, index: usize) -> Triangle {
        let Face {
            normals,
            normal,
            scale,
        } = self.faces[index];
        let vector = |index| self.vectors.get(index);
        Triangle {
            corners: self.corners[index],
            normals: normals.map(vector),
            geometric_normal: vector(normal),
            scale,
        }
    }

    /// Four numbers that lie together are read at once.
    #[inline(always)]
    fn four<S: Simd>(&self, simd: S, indices: [usize; 4]) -> Corners<S> {
        let four = indices.map(|index| &self.corners[index]);
        let first = four.map(|[a, b, _]| lanes(simd, [a.x, a.y, a.z, b.x]));
        let then = four.map(|[_, b, c]| lanes(simd, [b.y, b.z, c.x, c.y]));
        let [ax, ay, az, bx] = transposed(first);
        let [by, bz, cx, cy] = transposed(then);
        let cz = lanes(simd, four.map(|[_, _, c]| c.z));
        [[ax, ay, az], [bx, by, bz], [cx, cy, cz]]
    }

    #[inline(always)]
    fn splat<S: Simd>(&self, simd: S, index: usize) -> Corners<S> {
        let [a, b, c] = self.corners[index];
        [
            Vector3x4::splat(simd, a).axes(),
            Vector3x4::splat(simd, b).axes(),
            Vector3x4::splat(simd, c).axes(),
        ]
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.corners.swap(a, b);
        self.faces.swap(a, b);
    }
}
