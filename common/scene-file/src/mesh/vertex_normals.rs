//! Normals for corners that have none: the mean of the normals of the triangles around, weighted by
//! their angles (Thürmer and Wüthrich, *Computing Vertex Normals from Polygonal Facets*, 1998).

use std::collections::HashMap;

use glam::DVec3;

use super::{Mesh, NONE};

/// The numbers of triangles that lacked normals, by what became of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Smoothed {
    /// Smooth.
    pub smooth: usize,
    /// Flat, because the normals at a corner cancel out.
    pub flat: usize,
}

/// Corners whose coordinates are equal up to this part of the largest one are at the same place, such as
/// those at the pole of a globe, which a program computed one by one.
const SAME_PLACE: f64 = 1e-6;

/// A sum of normals that is a smaller part of the sum of their lengths is rounding.
const ROUNDING: f64 = 1e-9;

/// The sum of the weighted normals at a place, and the sum of their lengths.
#[derive(Clone, Copy, Default)]
struct Sum {
    normal: DVec3,
    lengths: f64,
}

impl Mesh {
    /// Computes the normals that corners lack. Corners at the same place share their normal, so
    /// that a triangle with corners of its own is smooth, too.
    pub(super) fn add_missing_normals(&mut self) -> Smoothed {
        let mut counts = Smoothed::default();
        let lacks = |triangle: &[[u32; 2]; 3]| triangle.iter().any(|[_, normal]| *normal == NONE);
        if !self.triangles.iter().any(lacks) {
            return counts;
        }
        let place_of = self.places();
        let mut sums = vec![Sum::default(); self.corners.len()];
        for triangle in &self.triangles {
            let corners = triangle.map(|[corner, _]| corner as usize);
            let positions = corners.map(|corner| DVec3::from(self.corners[corner]));
            let normals = weighted_normals(positions).unwrap_or_default();
            for (corner, normal) in corners.into_iter().zip(normals) {
                let sum = &mut sums[place_of[corner] as usize];
                sum.normal += normal;
                sum.lengths += normal.length();
            }
        }
        let first = self.normals.len() as u32;
        let computed = sums.iter().map(|sum| sum.normal.to_array());
        self.normals.extend(computed);
        for triangle in &mut self.triangles {
            if !lacks(triangle) {
                continue;
            }
            let places = triangle.map(|[corner, _]| place_of[corner as usize]);
            let is_rounding = |place: u32| {
                let Sum { normal, lengths } = sums[place as usize];
                normal.length() <= ROUNDING * lengths
            };
            if places.into_iter().any(is_rounding) {
                counts.flat += 1;
                continue;
            }
            counts.smooth += 1;
            for ([_, normal], place) in triangle.iter_mut().zip(places) {
                if *normal == NONE {
                    *normal = first + place;
                }
            }
        }
        counts
    }

    /// For each corner the first one that is at the same place.
    fn places(&self) -> Vec<u32> {
        let coordinates = self.corners.as_flattened().iter();
        let largest = coordinates.fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let cell = SAME_PLACE * largest;
        let mut first_of = HashMap::new();
        let mut places = Vec::new();
        for (corner, position) in (0..).zip(&self.corners) {
            let place = position.map(|x| (x / cell).round() as i64);
            places.push(*first_of.entry(place).or_insert(corner));
        }
        places
    }
}

/// The unit normal of a triangle for each of its corners, times the angle there in radians; none
/// for a triangle without area.
fn weighted_normals(corners: [DVec3; 3]) -> Option<[DVec3; 3]> {
    let [a, b, c] = corners;
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
