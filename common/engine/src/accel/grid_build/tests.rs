//! Tests of `grid_build`.

use super::*;

const EYE: RayBundle = RayBundle::Through(DVec3::ZERO);

/// A cube of this size with this middle.
fn cube(size: f64, middle: [f64; 3]) -> (Bounds, ShapeId) {
    let bounds = Bounds {
        min: middle.map(|x| x - size / 2.0),
        max: middle.map(|x| x + size / 2.0),
    };
    (bounds, ShapeId::Sphere(0))
}

fn side(shapes: &[(Bounds, ShapeId)]) -> usize {
    PerspectiveGrid::new(EYE, shapes).expect("a grid").side
}

/// 30² shapes, each of them in few cells: 120² are sixteen for each.
#[test]
fn there_are_sixteen_cells_for_a_shape() {
    let shapes: Vec<_> = (0..900)
        .map(|i| cube(1e-3, [f64::from(i % 30), f64::from(i / 30), -100.0]))
        .collect();
    assert_eq!(side(&shapes), 120);
    assert_eq!(side(&shapes[..9]), 64, "not too few");
}

/// Each of these shapes is in all 64² cells. 16 of them make 16 · 4096 entries, which
/// is the limit without shapes; each shape raises it by sixteen.
#[test]
fn where_shapes_fill_many_cells_there_are_fewer() {
    assert_eq!(side(&[cube(1.0, [0.0, 0.0, -10.0]); 16]), 64);
    assert_eq!(side(&[cube(1.0, [0.0, 0.0, -10.0]); 17]), 32);
}

/// Shapes on both sides, at these angles to the gaze between them. The largest angle
/// is some 80 degrees, for a scene of any size.
#[test]
fn shapes_too_far_aside_make_no_grid() {
    for size in [1e-3, 1.0, 1e3] {
        let is_seen = |degrees: f64| {
            let angle = degrees.to_radians();
            let (before, aside) = (size * libm::cos(angle), size * libm::sin(angle));
            let one = |aside| cube(size * 1e-3, [aside, 0.0, -before]);
            PerspectiveGrid::new(EYE, &[one(aside), one(-aside)]).is_some()
        };
        assert_eq!(
            [30.0, 80.0, 83.0, 89.0].map(is_seen),
            [true, true, false, false]
        );
    }
}
