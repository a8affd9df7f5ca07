//! `Triangulator`: cuts a polygon into triangles.

use earcut::Earcut;
use glam::DVec3;

/// A polygon whose normal is this much smaller than the triangles of its fan has an area of 0, but
/// for rounding.
const NO_AREA: f64 = 1e-12;

/// Cuts polygons, with memory that is used again for the next one.
#[derive(Default)]
pub struct Triangulator {
    /// The corners, without those that are where the one before is, and their numbers.
    corners: Vec<(DVec3, u32)>,
    earcut: Earcut<f64>,
    flat: Vec<[f64; 2]>,
    indices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Triangulator {
    /// The triangles of a polygon, which need be neither convex nor flat, as the numbers of their corners in
    /// the polygon's direction, if its border does not cross itself. One without area has none.
    pub fn cut(&mut self, points: impl Iterator<Item = [f64; 3]>) -> &[[u32; 3]] {
        self.triangles.clear();
        self.set_corners(points);
        if let Some(normal) = self.normal() {
            if self.is_convex(normal) || self.is_crossed(normal) {
                self.cut_fan();
            } else {
                self.cut_ears(normal);
            }
        }
        &self.triangles
    }

    /// Moves the first corner into the origin, and scales all by a power of 2, which loses no
    /// digits, so that squares neither overflow nor underflow.
    fn set_corners(&mut self, points: impl Iterator<Item = [f64; 3]>) {
        self.corners.clear();
        let mut first = DVec3::ZERO;
        let mut largest = 0.0;
        for (number, point) in (0..).zip(points) {
            let point = DVec3::from(point);
            if number == 0 {
                first = point;
            }
            let offset = point - first;
            if self.corners.last().is_none_or(|(last, _)| *last != offset) {
                largest = offset.abs().max_element().max(largest);
                self.corners.push((offset, number));
            }
        }
        while self.corners.len() > 1
            && self
                .corners
                .last()
                .is_some_and(|(last, _)| *last == DVec3::ZERO)
        {
            self.corners.pop();
        }
        if largest > 0.0 {
            let exponent = -libm::ilogb(largest);
            for (corner, _) in &mut self.corners {
                *corner = DVec3::from(corner.to_array().map(|x| libm::scalbn(x, exponent)));
            }
        }
    }

    /// The normal of the polygon, of any length; none if it has no area.
    ///
    /// It is the sum of the products of neighbouring corners (Newell; Sutherland, Sproull and
    /// Schumacker, *A Characterization of Ten Hidden-Surface Algorithms*, 1974). Where the border crosses
    /// itself so that these cancel, it is the largest of them.
    fn normal(&self) -> Option<DVec3> {
        let (mut sum, mut largest) = (DVec3::ZERO, DVec3::ZERO);
        let mut lengths = 0.0;
        for neighbours in self.corners.windows(2) {
            let product = neighbours[0].0.cross(neighbours[1].0);
            sum += product;
            lengths += product.length();
            if product.length() > largest.length() {
                largest = product;
            }
        }
        if sum.length() > NO_AREA * lengths {
            return Some(sum);
        }
        // The largest coordinate is 1 or more.
        (largest.length() > NO_AREA).then_some(largest)
    }

    /// Whether all corners turn in the same direction, and together go round once.
    fn is_convex(&self, normal: DVec3) -> bool {
        let count = self.corners.len();
        let is_left = |a: usize, b: usize, c: usize| {
            let [a, b, c] = [a, b, c].map(|i| self.corners[i % count].0);
            (b - a).cross(c - a).dot(normal) > 0.0
        };
        (0..count).all(|i| is_left(i, i + 1, i + 2)) && (1..count - 1).all(|i| is_left(0, i, i + 1))
    }

    /// Whether these are four corners whose border crosses itself: at either diagonal, the triangles on both
    /// sides turn in different directions.
    fn is_crossed(&self, normal: DVec3) -> bool {
        let area = |corners: [usize; 3]| {
            let [a, b, c] = corners.map(|i| self.corners[i].0);
            (b - a).cross(c - a).dot(normal)
        };
        self.corners.len() == 4
            && area([0, 1, 2]) * area([0, 2, 3]) < 0.0
            && area([1, 2, 3]) * area([1, 3, 0]) < 0.0
    }

    /// Cuts a polygon by the lines from its first corner.
    fn cut_fan(&mut self) {
        let first = self.corners[0].1;
        for neighbours in self.corners[1..].windows(2) {
            let [second, third] = [neighbours[0].1, neighbours[1].1];
            self.triangles.push([first, second, third]);
        }
    }

    /// Cuts a polygon into ears, as it is seen along the axis that is nearest to its normal: there
    /// corners on a line stay on it.
    fn cut_ears(&mut self, normal: DVec3) {
        let size = normal.abs();
        let axis = if size.x > size.y.max(size.z) {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (mut right, mut up) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 {
            (right, up) = (up, right);
        }
        let flat = self.corners.iter();
        self.flat.clear();
        self.flat
            .extend(flat.map(|(corner, _)| [corner[right], corner[up]]));
        self.earcut.earcut_slice(&self.flat, &[], &mut self.indices);
        for triangle in self.indices.as_chunks::<3>().0 {
            self.triangles
                .push(triangle.map(|i| self.corners[i as usize].1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of the areas of a polygon's triangles along a normal, none of which goes round the other
    /// way, but for rounding of numbers up to 10.
    fn area(points: &[[f64; 3]], normal: DVec3) -> f64 {
        let mut sum = 0.0;
        for triangle in Triangulator::default().cut(points.iter().copied()) {
            let [a, b, c] = triangle.map(|i| DVec3::from(points[i as usize]));
            let area = (b - a).cross(c - a).dot(normal) / 2.0;
            assert!(area > -1e-13, "{triangle:?} of {points:?}");
            sum += area;
        }
        sum
    }

    const T: [[f64; 2]; 8] = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 1.0],
        [2.0, 1.0],
        [2.0, 2.0],
        [1.0, 2.0],
        [1.0, 1.0],
        [0.0, 1.0],
    ];
    const DART: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [1.0, 1.0]];
    /// A square of side 3 with a hole of side 1, to which a bridge leads.
    const RING: [[f64; 2]; 10] = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [0.0, 3.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [2.0, 2.0],
        [2.0, 1.0],
        [1.0, 1.0],
    ];
    /// A doubled corner, a corner on a side, and the first one again at the end.
    const DOUBLED: [[f64; 2]; 8] = [
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [2.0, 0.0],
        [2.0, 2.0],
        [1.0, 1.0],
        [0.0, 2.0],
        [0.0, 0.0],
    ];
    const LINE: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [1.0, 1.0]];

    /// Four corners of a square and of other quadrilaterals, two of them exchanged, as files have them: the
    /// triangles on both sides of a diagonal.
    #[test]
    fn four_corners_whose_border_crosses_itself_are_two_triangles() {
        for [x, y] in [[1.0, 1.0], [1.0, 0.5], [2.0, 0.5]] {
            let mut points = [
                [-1.0, -1.0, 0.0],
                [x, y, 0.0],
                [1.0, -1.0, 0.0],
                [-1.0, 1.0, 0.0],
            ];
            for _ in 0..4 {
                points.rotate_left(1);
                let mut triangulator = Triangulator::default();
                let triangles = triangulator.cut(points.iter().copied());
                assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]], "{points:?}");
            }
        }
    }

    /// All numbers are small integers. The map (x, y) to (x + y, x - y, 2x + y) + (1, 1, 1) has the area
    /// factor √14: the product of its columns is (3, 1, -2).
    #[test]
    fn polygons_keep_their_area_from_every_corner_in_both_directions_in_any_plane() {
        let polygons: [(&[[f64; 2]], f64); 7] = [
            (&T, 4.0),
            (&DART, 1.0),
            (&RING, 8.0),
            (&DOUBLED, 3.0),
            (&LINE, 0.0),
            (&[[7.0, 7.0]; 5], 0.0),
            (&[], 0.0),
        ];
        for (polygon, expected) in polygons {
            for start in 0..polygon.len() {
                let mut points = polygon.to_vec();
                points.rotate_left(start);
                for turn in [1.0, -1.0] {
                    let level: Vec<_> = points.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
                    assert_eq!(area(&level, DVec3::Z * turn), expected, "{level:?}");
                    for scale in [1.0, 1e-90, 1e90] {
                        let leaning = points
                            .iter()
                            .map(|[x, y]| [x + y, x - y, 2.0 * x + y].map(|x| (x + 1.0) * scale));
                        let leaning: Vec<_> = leaning.collect();
                        let normal = DVec3::new(3.0, 1.0, -2.0) * (turn / 14.0 / scale / scale);
                        let area = area(&leaning, normal);
                        assert!((area - expected).abs() < 1e-12, "{area} of {leaning:?}");
                    }
                    points.reverse();
                }
            }
        }
    }
}
