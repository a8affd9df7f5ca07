//! Normals for corners that have none: the mean of the normals of the triangles around, weighted by
//! their angles (Thürmer and Wüthrich, *Computing Vertex Normals from Polygonal Facets*, 1998).

use std::collections::HashMap;

use glam::DVec3;

use super::places::places;
use super::sides::across;
use super::{Mesh, NONE};

/// The numbers of triangles that lacked normals, by what became of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Smoothed {
    /// Smooth.
    pub smooth: usize,
    /// Flat, because no surface goes on from them, because they are too narrow, or because normals
    /// cancel out.
    pub flat: usize,
}

/// A sum of normals that is a smaller part of the sum of their lengths is rounding.
const ROUNDING: f64 = 1e-9;

impl Mesh {
    /// Computes the normals that corners lack. Corners at the same place share their normal, so
    /// that a triangle with corners of its own is smooth, too. It does not matter in which
    /// direction triangles go round, nor whether some of them are there twice.
    pub(super) fn add_missing_normals(&mut self) -> Smoothed {
        let mut counts = Smoothed::default();
        let corners: Vec<_> = (self.triangles.iter())
            .map(|triangle| triangle.map(|[corner, _]| corner))
            .collect();
        let lacks = |triangle: &[[u32; 2]; 3]| triangle.iter().any(|[_, normal]| *normal == NONE);
        if !self.triangles.iter().any(lacks) {
            return counts;
        }
        let place_of = places(&self.corners, &corners);
        let at = |corner: u32| DVec3::from(self.corners[corner as usize]);
        let mut weighted = Vec::with_capacity(corners.len());
        let mut faces = Vec::with_capacity(corners.len());
        let mut first_of = HashMap::new();
        let mut twins = Vec::new();
        for (triangle, corners) in corners.iter().enumerate() {
            let places @ [a, b, c] = corners.map(|corner| place_of[corner as usize]);
            let normals = weighted_normals(corners.map(at));
            let mut face = None;
            if normals.is_some() && a != b && b != c && c != a {
                let mut key = places;
                key.sort_unstable();
                let first = *first_of.entry(key).or_insert(triangle);
                if first == triangle {
                    face = Some(places);
                } else {
                    twins.push((triangle, first, places));
                }
            }
            faces.push(face);
            weighted.push(normals.unwrap_or_default());
        }
        let fans = Fans {
            across: across(&faces, at),
            faces,
        };

        let mut normal_of = vec![NONE; 3 * corners.len()];
        let mut is_alone = vec![true; 3 * corners.len()];
        for first in 0..3 * corners.len() as u32 {
            if normal_of[first as usize] != NONE || fans.place(first).is_none() {
                continue;
            }
            let mut fan = fans.around(first);
            fan.sort_unstable();
            let (mut sum, mut lengths) = (DVec3::ZERO, 0.0);
            for (corner, is_turned) in &fan {
                let normal = weighted.as_flattened()[*corner as usize];
                sum += if *is_turned { -normal } else { normal };
                lengths += normal.length();
            }
            let is_rounding = sum.length() <= ROUNDING * lengths;
            let index = self.normals.len() as u32;
            self.normals.push(sum.to_array());
            if fan.iter().any(|(_, is_turned)| *is_turned) {
                self.normals.push((-sum).to_array());
            }
            for (corner, is_turned) in &fan {
                let of_corner = index + u32::from(*is_turned);
                normal_of[*corner as usize] = if is_rounding { CANCELLED } else { of_corner };
                is_alone[*corner as usize] = fan.len() == 1;
            }
        }
        for (twin, first, places) in twins {
            for (i, place) in places.into_iter().enumerate() {
                let of_first = (0..3).find(|j| fans.place((3 * first + j) as u32) == Some(place));
                let (own, other) = (3 * twin + i, 3 * first + of_first.unwrap_or(i));
                normal_of[own] = normal_of[other];
                is_alone[own] = is_alone[other];
            }
        }
        for (i, triangle) in self.triangles.iter_mut().enumerate() {
            if !lacks(triangle) {
                continue;
            }
            let own = 3 * i..3 * i + 3;
            let (normals, are_alone) = (&normal_of[own.clone()], &is_alone[own]);
            if normals.contains(&CANCELLED) || are_alone == [true; 3] {
                counts.flat += 1;
            } else {
                counts.smooth += 1;
                for ([_, normal], computed) in triangle.iter_mut().zip(normals) {
                    if *normal == NONE {
                        *normal = *computed;
                    }
                }
            }
        }
        counts
    }
}

/// The index of a normal that is only rounding.
const CANCELLED: u32 = NONE - 1;

/// Triangles whose sides lead from one to the other. A corner has the number of its side, see
/// [`across`].
struct Fans {
    /// The places of the corners of each triangle; none for one that is too narrow, or that has
    /// the corners of an earlier one.
    faces: Vec<Option<[u32; 3]>>,
    across: Vec<u32>,
}

impl Fans {
    fn place(&self, corner: u32) -> Option<u32> {
        let [triangle, i] = [corner / 3, corner % 3].map(|i| i as usize);
        self.faces[triangle].map(|places| places[i])
    }

    /// The corners at the place of the first one to which sides lead from it, and whether the
    /// triangle of each goes round in the other direction than that of the first.
    fn around(&self, first: u32) -> Vec<(u32, bool)> {
        let mut fan = vec![(first, false)];
        // The side that begins at a corner, and the one that ends there.
        for mut side in [first, previous(first)] {
            let (mut corner, mut is_turned) = (first, false);
            while let other = self.across[side as usize]
                && other != NONE
            {
                let other_begins = self.place(other) == self.place(first);
                is_turned ^= other_begins == (side == corner);
                corner = if other_begins { other } else { next(other) };
                if corner == first {
                    return fan;
                }
                fan.push((corner, is_turned));
                side = if other_begins {
                    previous(corner)
                } else {
                    corner
                };
            }
        }
        fan
    }
}

/// The next corner of the same triangle.
const fn next(corner: u32) -> u32 {
    if corner % 3 == 2 {
        corner - 2
    } else {
        corner + 1
    }
}

/// The corner before in the same triangle.
const fn previous(corner: u32) -> u32 {
    next(next(corner))
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
