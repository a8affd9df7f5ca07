//! `Mesh`: the sphere as triangles, for rays that aim at corners and edges.

use std::collections::HashMap;
use std::mem;

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
        let mut corners = Vec::new();
        for (one, more) in [
            (1.0, golden),
            (-1.0, golden),
            (1.0, -golden),
            (-1.0, -golden),
        ] {
            for corner in [[0.0, one, more], [one, more, 0.0], [more, 0.0, one]] {
                corners.push(on_unit_sphere(vector(corner)));
            }
        }
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
        for _ in 0..divisions {
            mesh.divide();
        }
        mesh
    }

    /// Divides each face into four at the middles of its edges.
    fn divide(&mut self) {
        let mut middles = HashMap::new();
        let mut quarters = Vec::new();
        for [a, b, c] in mem::take(&mut self.faces) {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(i, j)| {
                // Both faces at an edge share its middle.
                let edge = (i.min(j), i.max(j));
                *middles.entry(edge).or_insert_with(|| self.add_middle(i, j))
            });
            quarters.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        self.faces = quarters;
    }

    /// Adds the corner in the middle of an edge, and returns its index.
    fn add_middle(&mut self, i: usize, j: usize) -> usize {
        let middle = on_unit_sphere(self.corners[i] + self.corners[j]);
        self.corners.push(middle);
        self.corners.len() - 1
    }
}

fn on_unit_sphere(v: Vector3) -> Vector3 {
    v * (1.0 / v.magnitude())
}
