//! `Mesh`: triangles, whose corners lie apart from what only their hits need.

use glam::DVec3;

use super::{Corners, List, Triangle, triangle};
use crate::lanes::{Simd, lanes, transposed};

/// Triangles. Most tests read nothing but corners, and those of the four triangles of a leaf lie
/// side by side.
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    corners: Vec<[DVec3; 3]>,
    faces: Vec<Face>,
}

/// The shading normals and the geometric one of a triangle, and its scale.
#[derive(Clone, Copy, Debug)]
struct Face {
    normals: [DVec3; 3],
    geometric_normal: DVec3,
    scale: f64,
}

impl Mesh {
    pub fn push(&mut self, triangle: &Triangle) {
        self.corners.push(triangle.corners);
        self.faces.push(Face {
            normals: triangle.normals,
            geometric_normal: triangle.geometric_normal,
            scale: triangle.scale,
        });
    }
}

impl List for Mesh {
    type Shape<'s> = Triangle;

    #[inline]
    fn get(&self, index: usize) -> Triangle {
        let Face {
            normals,
            geometric_normal,
            scale,
        } = self.faces[index];
        Triangle {
            corners: self.corners[index],
            normals,
            geometric_normal,
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
        triangle::splat(simd, self.corners[index])
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.corners.swap(a, b);
        self.faces.swap(a, b);
    }
}
