//! `Mesh`: the sphere as triangles, for rays that aim at corners and edges.

use std::collections::HashMap;

use a02_math::{Direction, Vector3};

use crate::support::vector;

/// An icosphere: an icosahedron whose faces are divided into four.
pub struct Mesh {
    pub corners: Vec<Vector3>,
    /// Indices of three corners, counterclockwise seen from outside.
    pub faces: Vec<[usize; 3]>,
}

impl Mesh {
    /// 20 · 4^`divisions` triangles with corners on the unit sphere.
    pub fn icosphere(divisions: u32) -> Self {
        let golden = f64::midpoint(1.0, 5_f64.sqrt());
        let signs = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        let corners = signs.into_iter().flat_map(|(one, more)| {
            let (one, more) = (one, more * golden);
            [[0.0, one, more], [one, more, 0.0], [more, 0.0, one]]
        });
        let corners = corners.map(|corner| on_unit_sphere(vector(corner)));
        let corners: Vec<_> = corners.collect();
        // The distance of neighbours on the unit sphere is 1.05, of others more.
        let is_edge = |i: usize, j: usize| (corners[i] - corners[j]).magnitude() < 1.1;
        let mut faces = Vec::new();
        for i in 0..12 {
            for j in (i + 1..12).filter(|j| is_edge(i, *j)) {
                for k in (j + 1..12).filter(|k| is_edge(i, *k) && is_edge(j, *k)) {
                    let [a, b, c] = [i, j, k].map(|corner| corners[corner]);
                    let is_outwards = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if is_outwards { [i, j, k] } else { [i, k, j] });
                }
            }
        }
        let mut mesh = Self { corners, faces };
        (0..divisions).for_each(|_| mesh.divide());
        mesh
    }

    fn divide(&mut self) {
        let mut middles = HashMap::new();
        let corners = &mut self.corners;
        let mut middle = |i: usize, j: usize| {
            *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                corners.push(on_unit_sphere(corners[i] + corners[j]));
                corners.len() - 1
            })
        };
        let quarters = |&[a, b, c]: &[usize; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        self.faces = self.faces.iter().flat_map(quarters).collect();
    }
}

fn on_unit_sphere(v: Vector3) -> Vector3 {
    v * (1.0 / v.magnitude())
}
