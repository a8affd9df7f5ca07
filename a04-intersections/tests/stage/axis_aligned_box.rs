//! Boxes: rays that run within a face or along an edge. Rays aimed at random places of a
//! box are the extreme cases S07 to S09; each face from both sides, edges and corners are the exercise
//! `axis_aligned_box`.

use a04_intersections::AxisAlignedBox;

use crate::test_shapes::{Case, assert_hits, point};

/// Three zeros, but for `value` at `axis`.
fn along(axis: usize, value: f64) -> [f64; 3] {
    let mut all = [0.0; 3];
    all[axis] = value;
    all
}

/// Along every axis, both ways, through the middle, within the faces, along
/// the edges, with zeros of both signs: the box is closed.
#[test]
fn rays_within_a_face_or_along_an_edge_hit() {
    let cube = AxisAlignedBox::new(point([0.0; 3]), point([1.0; 3])).unwrap();
    let zeros = [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)];
    for axis in 0..3 {
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        for (from, way) in [(5.0, -1.0), (-4.0, 1.0)] {
            for (x, y) in (0..9).map(|i| (f64::from(i / 3) / 2.0, f64::from(i % 3) / 2.0)) {
                for (zero_p, zero_q) in zeros {
                    let (mut o, mut d) = (along(axis, from), along(axis, way));
                    (o[p], o[q], d[p], d[q]) = (x, y, zero_p, zero_q);
                    let case: Case = (o, d, Some((4.0, along(axis, -way))));
                    o[p] = if x < 0.5 { -5e-324 } else { 1_f64.next_up() };
                    assert_hits(&cube, &[case, (o, d, None)]);
                }
            }
        }
    }
}
