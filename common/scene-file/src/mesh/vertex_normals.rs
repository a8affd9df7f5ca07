//! Normals for corners that have none: the mean of the normals of the triangles around, weighted by
//! their angles (Thürmer and Wüthrich, *Computing Vertex Normals from Polygonal Facets*, 1998).

use std::collections::HashMap;

use glam::DVec3;

use super::{Mesh, NONE};

impl Mesh {
    /// Computes the normals that corners lack, and returns the number of triangles at which there
    /// are any. Corners at the same place share their normal, so that a triangle with corners of
    /// its own is smooth, too. The triangles around a corner have to go round in the same
    /// direction.
    pub(super) fn add_missing_normals(&mut self) -> usize {
        let mut places = HashMap::new();
        // For each corner, the sum of the place where it is; none for one that needs no normal.
        let mut place_of = vec![None; self.corners.len()];
        for [corner, normal] in self.triangles.as_flattened() {
            if *normal == NONE {
                let count = places.len();
                let position = self.corners[*corner as usize];
                // The sum turns -0 into 0, which is the same place.
                let place = places.entry(position.map(|x| (x + 0.0).to_bits()));
                place_of[*corner as usize] = Some(*place.or_insert(count));
            }
        }
        let mut sums = vec![DVec3::ZERO; places.len()];
        for triangle in &self.triangles {
            let positions = triangle.map(|[corner, _]| self.corners[corner as usize]);
            let Some(angles) = weighted_normals(positions) else {
                continue;
            };
            for (position, angle) in positions.iter().zip(angles) {
                if let Some(place) = places.get(&position.map(|x| (x + 0.0).to_bits())) {
                    sums[*place] += angle;
                }
            }
        }
        let first = self.normals.len() as u32;
        self.normals.extend(sums.iter().map(DVec3::to_array));
        let mut count = 0;
        for triangle in &mut self.triangles {
            let is_lacking = triangle.iter().any(|[_, normal]| *normal == NONE);
            count += usize::from(is_lacking);
            for [corner, normal] in triangle {
                if *normal == NONE
                    && let Some(place) = place_of[*corner as usize]
                    && sums[place] != DVec3::ZERO
                {
                    *normal = first + place as u32;
                }
            }
        }
        count
    }
}

/// The unit normal of a triangle for each of its corners, times the angle there in radians; none
/// for a triangle without area.
fn weighted_normals(corners: [[f64; 3]; 3]) -> Option<[DVec3; 3]> {
    let [a, b, c] = corners.map(DVec3::from);
    let [ab, bc, ca] = [unit(b - a)?, unit(c - b)?, unit(a - c)?];
    // The unit vectors with the largest angle between them have the most exact product.
    let products = [ab.cross(bc), bc.cross(ca), ca.cross(ab)];
    let normal = products
        .into_iter()
        .max_by(|v, w| v.length_squared().total_cmp(&w.length_squared()))?;
    let normal = unit(normal)?;
    let angle = |v: DVec3, w: DVec3| libm::atan2(v.cross(w).length(), v.dot(w));
    Some([angle(ab, -ca), angle(bc, -ab), angle(ca, -bc)].map(|angle| normal * angle))
}

/// A vector of length 1, also if the square of its length is no number.
fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (largest > 0.0).then(|| (v / largest).normalize())
}
