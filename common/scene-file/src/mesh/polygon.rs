//! `Triangulator`: cuts a polygon into triangles.

use earcut::Earcut;
use glam::DVec3;

/// Most corners of a polygon that is not convex: the time to cut one grows with their square.
pub const MOST_CORNERS: usize = 16_384;

/// A polygon whose normal is this much smaller than the triangles of its fan has an area of 0, but
/// for rounding.
const NO_AREA: f64 = 1e-12;

/// Largest distance of the corners from the plane of a flat polygon, as a fraction of its size.
const FLAT: f64 = 1e-9;

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

/// A polygon as triangles.
pub struct Cut<'a> {
    /// The numbers of the corners, in the polygon's direction.
    pub triangles: &'a [[u32; 3]],
    /// Whether its border crosses itself.
    pub crosses_itself: bool,
}

impl Triangulator {
    /// Cuts a polygon, which need be neither convex nor flat: what counts is its projection along
    /// its normal. One without area has no triangles. The error is the end of a sentence about the
    /// face.
    pub fn cut(&mut self, points: impl Iterator<Item = [f64; 3]>) -> Result<Cut<'_>, String> {
        self.triangles.clear();
        self.set_corners(points);
        let mut crosses_itself = false;
        if let Some(normal) = self.normal() {
            if let Some(first) = self.first_of_fan(normal) {
                self.cut_fan(first);
            } else if self.corners.len() > MOST_CORNERS {
                let count = self.corners.len();
                return Err(format!(
                    "has {count} corners, but a face that is not convex has at most {MOST_CORNERS}"
                ));
            } else {
                crosses_itself = self.cut_ears(normal);
            }
        }
        Ok(Cut {
            triangles: &self.triangles,
            crosses_itself,
        })
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
    /// Schumacker, *A Characterization of Ten Hidden-Surface Algorithms*, 1974). Where the border
    /// crosses itself so that its parts cancel, it is the normal of the largest triangle.
    fn normal(&self) -> Option<DVec3> {
        let mut sum = DVec3::ZERO;
        let mut all = 0.0;
        let mut largest = (0.0, DVec3::ZERO);
        for neighbours in self.corners.windows(2) {
            let product = neighbours[0].0.cross(neighbours[1].0);
            let length = product.length();
            sum += product;
            all += length;
            if length > largest.0 {
                largest = (length, product);
            }
        }
        if sum.length() > NO_AREA * all {
            return Some(sum);
        }
        (largest.0 > 0.0).then_some(largest.1)
    }

    /// The corner from which all others are seen around a convex polygon, or one of four corners;
    /// none if there is no such corner.
    fn first_of_fan(&self, normal: DVec3) -> Option<usize> {
        let corners = &self.corners;
        let count = corners.len();
        let is_right = |a: usize, b: usize, c: usize| {
            let [a, b, c] = [a, b, c].map(|i| corners[i % count].0);
            (b - a).cross(c - a).dot(normal) > 0.0
        };
        if count <= 4 {
            let mut firsts = 0..count.saturating_sub(2);
            return firsts.find(|i| (1..count - 1).all(|k| is_right(*i, i + k, i + k + 1)));
        }
        // All corners turn in the same direction, and together they go round once.
        let turns = (0..count).all(|i| is_right(i, i + 1, i + 2));
        (turns && (1..count - 1).all(|i| is_right(0, i, i + 1))).then_some(0)
    }

    /// Cuts a polygon by the lines from a corner.
    fn cut_fan(&mut self, first: usize) {
        let count = self.corners.len();
        let number = |i: usize| self.corners[i % count].1;
        for i in first + 1..first + count - 1 {
            let triangle = [number(first), number(i), number(i + 1)];
            self.triangles.push(triangle);
        }
    }

    /// Cuts the projection of a polygon along its normal into ears, and returns whether the border
    /// crosses itself: then the triangles cover another area than it surrounds.
    fn cut_ears(&mut self, normal: DVec3) -> bool {
        // The axis that is nearest to the normal is left out.
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
        // Of a flat polygon two coordinates are enough, and they are not rounded: corners on a line
        // stay on it.
        let unit = normal.normalize();
        let is_flat = self
            .corners
            .iter()
            .all(|(corner, _)| corner.dot(unit).abs() < FLAT);
        let slope = [right, up].map(|axis_up| {
            let slope = normal[axis_up] / normal[axis];
            if is_flat { 0.0 } else { slope }
        });
        self.flat.clear();
        for (corner, _) in &self.corners {
            let along = corner[axis];
            let x = corner[right] - slope[0] * along;
            let y = corner[up] - slope[1] * along;
            self.flat.push([x, y]);
        }
        let Self { earcut, flat, .. } = self;
        earcut.earcut_slice(flat, &[], &mut self.indices);
        let mut covered = 0.0;
        for triangle in self.indices.as_chunks::<3>().0 {
            let [a, b, c] = triangle.map(|i| flat[i as usize]);
            covered += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
            self.triangles
                .push(triangle.map(|i| self.corners[i as usize].1));
        }
        let mut surrounded = 0.0;
        for (i, a) in flat.iter().enumerate() {
            let b = flat[(i + 1) % flat.len()];
            surrounded += a[0] * b[1] - a[1] * b[0];
        }
        (covered - surrounded).abs() > 1e-9 * covered + 1e-12
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The triangles of a polygon, and whether its border crosses itself.
    fn cut(points: &[[f64; 3]]) -> (Vec<[u32; 3]>, bool) {
        let mut triangulator = Triangulator::default();
        let cut = triangulator.cut(points.iter().copied()).unwrap();
        (cut.triangles.to_vec(), cut.crosses_itself)
    }

    /// The sum of the areas, positive where a triangle goes round as the normal says.
    fn area(points: &[[f64; 3]], triangles: &[[u32; 3]], normal: DVec3) -> f64 {
        let mut sum = 0.0;
        for triangle in triangles {
            let [a, b, c] = triangle.map(|i| DVec3::from(points[i as usize]));
            let area = (b - a).cross(c - a).dot(normal) / 2.0;
            // Rounding may leave a triangle of corners on a line.
            assert!(
                area > -1e-14,
                "{triangle:?} of {points:?} has the area {area}"
            );
            sum += area;
        }
        sum
    }

    /// A polygon in the plane z = 0.
    fn in_plane(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
        points.iter().map(|[x, y]| [*x, *y, 0.0]).collect()
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

    #[test]
    fn concave_polygons_keep_their_area_from_every_corner_in_both_directions() {
        let dart = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [1.0, 1.0]];
        // A square of side 3 with a hole of side 1, to which a bridge leads.
        let ring = [
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
        // Doubled corners, and a corner on a side.
        let doubled = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [1.0, 1.0],
            [0.0, 2.0],
            [0.0, 0.0],
        ];
        let pentagon = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        let polygons: [(&[[f64; 2]], f64); 5] = [
            (&T, 4.0),
            (&dart, 1.0),
            (&ring, 8.0),
            (&doubled, 3.0),
            (&pentagon, 2.0),
        ];
        for (polygon, expected) in polygons {
            for start in 0..polygon.len() {
                let mut points = in_plane(polygon);
                points.rotate_left(start);
                for normal in [DVec3::Z, -DVec3::Z] {
                    let (triangles, crosses) = cut(&points);
                    assert!(!crosses, "{points:?}");
                    // All numbers are small integers.
                    assert_eq!(area(&points, &triangles, normal), expected, "{points:?}");
                    points.reverse();
                }
            }
        }
    }

    /// The map (x, y) to (x + y, x - y, 2x + y) + (1, 1, 1) has the area factor √14: the product of
    /// its columns is (3, 1, -2).
    #[test]
    fn planes_of_any_direction_and_any_size_are_projected_along_their_normal() {
        for scale in [1.0, 1e-90, 1e90] {
            let point = |[x, y]: &[f64; 2]| [x + y, x - y, 2.0 * x + y].map(|x| (x + 1.0) * scale);
            let points: Vec<_> = T.iter().map(point).collect();
            let (triangles, crosses) = cut(&points);
            assert!(!crosses);
            let points: Vec<_> = points.iter().map(|p| p.map(|x| x / scale)).collect();
            let normal = DVec3::new(3.0, 1.0, -2.0) / 14_f64.sqrt();
            let area = area(&points, &triangles, normal);
            // Rounding of six triangles with coordinates up to 10.
            assert!((area - 4.0 * 14_f64.sqrt()).abs() < 1e-12, "{area}");
        }
    }

    /// The height of a corner changes no area of the projection.
    #[test]
    fn a_polygon_that_is_not_flat_keeps_its_projection() {
        let mut points = in_plane(&T);
        // Opposite corners, whose heights leave the normal upright: the sum of the products of
        // each height with the displacement between the corner's neighbours is 0.
        for (corner, height) in [(0, 0.5), (1, 0.5), (2, 0.5), (7, 0.5)] {
            points[corner][2] = height;
        }
        let (triangles, crosses) = cut(&points);
        assert!(!crosses);
        let normal: DVec3 = (0..8)
            .map(|i| DVec3::from(points[i]).cross(DVec3::from(points[(i + 1) % 8])))
            .sum();
        let projected = area(&points, &triangles, normal.normalize());
        assert!((projected - normal.length() / 2.0).abs() < 1e-12);
    }

    #[test]
    fn polygons_without_area_have_no_triangles_and_crossing_ones_are_named() {
        let line = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [1.0, 1.0]];
        for points in [&line[..], &[[7.0, 7.0]; 5], &[[1.0, 2.0]; 1], &[]] {
            let (triangles, crosses) = cut(&in_plane(points));
            assert!(triangles.is_empty() && !crosses, "{points:?}");
        }
        let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(cut(&in_plane(&bow_tie)).1);
        let mut triangulator = Triangulator::default();
        let star = (0..=2 * MOST_CORNERS).map(|i| {
            let angle = i as f64 / MOST_CORNERS as f64 * 3.0;
            let radius = [1.0, 0.5][i % 2];
            [radius * libm::cos(angle), radius * libm::sin(angle), 0.0]
        });
        let error = triangulator.cut(star).err().unwrap();
        assert!(error.starts_with("has 32769 corners, but"), "{error}");
    }
}
