//! Boxes: edges, corners, and rays that run within a face. Rays aimed at random places of a
//! box are the extreme cases S07 to S09; each face from both sides is the exercise
//! `axis_aligned_box`.

use a04_intersections::AxisAlignedBox;

use a04_lab::test_shapes::{Case, assert_hits, hit, point, ray};

fn box_between(lbf: [f64; 3], run: [f64; 3]) -> AxisAlignedBox {
    AxisAlignedBox::new(point(lbf), point(run)).unwrap()
}

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
    let cube = box_between([0.0; 3], [1.0; 3]);
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

/// A box may have no width, like a rectangle, or no extent at all, like a point.
#[test]
fn corners_edges_and_flat_boxes_are_hit() {
    let (unit, flat) = ([[0.0; 3], [1.0; 3]], [[0.0, 1.0, 0.0], [2.0, 1.0, 2.0]]);
    let (speck, down) = ([[1.0, 2.0, 2.0]; 2], [0.0, -1.0, 0.0]);
    for ([lbf, run], o, d, t) in [
        // Through the corner (1, 1, 1) to (0, 0, 0).
        (unit, [2.0; 3], [-1.0; 3], Some(1.0)),
        // Touching only the edge x = 1, y = 1, and only the corner (1, 1, 1).
        (unit, [0.0, 2.0, 0.5], [1.0, -1.0, 0.0], Some(1.0)),
        (unit, [0.0, 2.0, 3.0], [1.0, -1.0, -2.0], Some(1.0)),
        (unit, [0.0, 2.000_001, 0.5], [1.0, -1.0, 0.0], None),
        (unit, [0.0, 2.000_001, 3.0], [1.0, -1.0, -2.0], None),
        (flat, [2.0, 4.0, 0.5], down, Some(3.0)),
        (flat, [2.5, 4.0, 0.5], down, None),
        (speck, [0.0; 3], [1.0, 2.0, 2.0], Some(1.0)),
        (speck, [0.0; 3], [1.0, 2.0, 2.1], None),
    ] {
        let found = hit(&box_between(lbf, run), &ray(o, d));
        assert_eq!(found.map(|hit| hit.t), t, "{o:?} {d:?}");
    }
}
