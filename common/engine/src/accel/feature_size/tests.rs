//! Tests of `feature_size`.

use glam::DVec3;

use super::*;
use crate::accel::shapes::ShapeId;
use crate::shape::Bounds;

const EYE: RayBundle = RayBundle::Through(DVec3::ZERO);

/// A cube of this size with this middle.
fn cube(size: f64, middle: [f64; 3]) -> (Bounds, ShapeId) {
    let bounds = Bounds {
        min: middle.map(|x| x - size / 2.0),
        max: middle.map(|x| x + size / 2.0),
    };
    (bounds, ShapeId::Sphere(0))
}

const fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray { origin, direction }
}

/// A rectangle at the distance 1 in front of the eye, where places are coordinates.
fn flat([left, low]: [f64; 2], [right, high]: [f64; 2]) -> (Bounds, ShapeId) {
    let bounds = Bounds {
        min: [left, low, -1.0],
        max: [right, high, -1.0],
    };
    (bounds, ShapeId::Sphere(0))
}

/// Fills the grid, 64 x 64 cells, each 1/32 wide: it is so wide that no ray pattern
/// misses it.
fn wall() -> (Bounds, ShapeId) {
    flat([-1.0, -1.0], [1.0, 1.0])
}

/// Rays from the eye to the corners of a rectangle at the distance 1 in front of it.
fn corners([left, low]: [f64; 2], [right, high]: [f64; 2]) -> [Ray; 4] {
    [(left, high), (right, high), (left, low), (right, low)]
        .map(|(x, y)| ray(DVec3::ZERO, DVec3::new(x, y, -1.0)))
}

/// Whether a square with this lower left corner may miss one of the shapes.
fn hides(shapes: &[(Bounds, ShapeId)], [left, low]: [f64; 2], side: f64, narrow: f64) -> bool {
    let corners = corners([left, low], [left + side, low + side]);
    let grid = PerspectiveGrid::new(EYE, shapes).expect("a grid");
    let may_miss_features = grid.may_miss_features(&corners, narrow);
    may_miss_features.expect("rays of the grid")
}

/// The face of the cube is 10 away and 1 wide, so that it appears 0.1 wide, which is a
/// twentieth of a square of side 2.
#[test]
fn a_cube_narrower_than_the_feature_size_may_be_missed() {
    let alone = [cube(1.0, [0.0, 0.0, -10.5])];
    for at in [[-1.0, -1.0], [0.02, -1.0], [-1.0, 0.02], [-2.02, -2.02]] {
        assert!(hides(&alone, at, 2.0, 0.0501), "{at:?}");
        assert!(!hides(&alone, at, 2.0, 0.0499), "{at:?}");
    }
    assert!(hides(&alone, [-2.0, -2.0], 4.0, 0.0251));
    assert!(!hides(&alone, [-2.0, -2.0], 4.0, 0.0249));
}

/// For a rotated camera the square is rotated, too.
#[test]
fn the_longer_side_of_a_rectangle_counts() {
    let grid = PerspectiveGrid::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a grid");
    for (from, to) in [([-1.0, -0.2], [1.0, 0.2]), ([-0.2, -1.0], [0.2, 1.0])] {
        let corners = corners(from, to);
        let hides = [0.0501, 0.0499].map(|narrow| grid.may_miss_features(&corners, narrow));
        assert_eq!(hides, [Some(true), Some(false)]);
    }
}

/// Both sticks are 0.1 wide one way and 0.6 the other, an eighth and three quarters of
/// the square.
#[test]
fn a_shape_that_is_narrow_one_way_may_be_missed() {
    let upright = flat([0.5, 0.3], [0.6, 0.9]);
    let lying = flat([0.3, 0.5], [0.9, 0.6]);
    let (Bounds { min, max }, shape) = wall();
    let [min, max] = [min, max].map(|corner| corner.map(|x| 2.0 * x));
    let far_wall = (Bounds { min, max }, shape);
    for stick in [upright, lying] {
        // Seen from the eye, one wall comes before the stick, the other behind it.
        for shapes in [[stick, wall()], [stick, far_wall]] {
            assert!(hides(&shapes, [0.2, 0.2], 0.8, 0.126));
            assert!(!hides(&shapes, [0.2, 0.2], 0.8, 0.124));
        }
    }
}

/// The shape is in the cells that begin at 3/32 and end at 7/32, both ways.
#[test]
fn a_shape_may_be_missed_only_in_its_cells() {
    let shapes = [wall(), flat([0.1, 0.1], [0.2, 0.2])];
    let hides = |at| hides(&shapes, at, 0.5, 1.0);
    for inside in [[-0.1, -0.1], [-0.39, 0.19], [0.19, 0.19], [0.19, -0.39]] {
        assert!(hides(inside), "{inside:?}");
    }
    for beside in [0.22, 0.3, -0.41, -0.5] {
        for across in [-0.39, -0.1, 0.19] {
            assert!(!hides([beside, across]), "{beside}, {across}");
            assert!(!hides([across, beside]), "{across}, {beside}");
        }
        assert!(!hides([beside, beside]), "{beside}");
    }
}

/// The cells end where the shape ends. Squares that reach beyond still find it.
#[test]
fn no_shape_is_missed_outside_of_the_grid() {
    let upright = flat([-0.1, -0.2], [0.1, 0.2]);
    let lying = flat([-0.2, -0.1], [0.2, 0.1]);
    for (alone, [x, y]) in [(upright, [0.1, 0.2]), (lying, [0.2, 0.1])] {
        let hides = |at| hides(&[alone], at, 2.0, 0.2);
        for (beyond, is_in) in [(0.01, false), (-0.01, true)] {
            let (right, above) = (x + beyond, y + beyond);
            let (left, below) = (-2.0 - right, -2.0 - above);
            for at in [[right, -1.0], [left, -1.0], [-1.0, above], [-1.0, below]] {
                assert_eq!(hides(at), is_in, "{at:?}");
            }
            for at in [[right, above], [right, below], [left, above], [left, below]] {
                assert_eq!(hides(at), is_in, "{at:?}");
            }
        }
    }
}

#[test]
fn up_to_three_in_a_cell_may_miss_features() {
    let hides = |count| {
        let shapes = vec![cube(1.0, [0.0, 0.0, -10.5]); count];
        hides(&shapes, [-1.0, -1.0], 2.0, 0.1)
    };
    assert_eq!([1, 2, 3, 4, 5].map(hides), [true, true, true, false, false]);
}

/// A band 0.05 high, one of two shapes on the left and one of four on the right.
#[test]
fn no_shape_is_missed_in_a_crowded_cell() {
    let band = flat([-0.9, 0.0], [0.9, 0.05]);
    let right = flat([0.1, -1.0], [1.0, 1.0]);
    let hides = |left| hides(&[wall(), right, band, right], [left, -0.4], 0.6, 0.1);
    assert_eq!([-0.9, -0.3, 0.2].map(hides), [true, true, false]);
}

#[test]
fn rays_from_elsewhere_do_not_belong_to_the_bundle() {
    let grid = PerspectiveGrid::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a grid");
    let of_grid = corners([-1.0, -1.0], [1.0, 1.0]);
    assert_eq!(grid.may_miss_features(&of_grid, 0.1), Some(true));
    for i in 0..4 {
        let mut corners = of_grid;
        let beside = DVec3::new(0.0, 1e-12, 0.0);
        corners[i] = ray(beside, corners[i].direction);
        assert_eq!(grid.may_miss_features(&corners, 0.1), None, "corner {i}");
    }
}

#[test]
fn rays_that_look_back_do_not_belong_to_the_bundle() {
    let grid = PerspectiveGrid::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a grid");
    for i in 0..4 {
        let mut corners = corners([-1.0, -1.0], [1.0, 1.0]);
        corners[i] = ray(DVec3::ZERO, -corners[i].direction);
        assert_eq!(grid.may_miss_features(&corners, 0.1), None, "corner {i}");
    }
}

#[test]
fn parallel_rays_have_no_feature_size() {
    let ahead = DVec3::new(0.0, 0.0, -1.0);
    let alone = [cube(1.0, [0.0, 0.0, -10.5])];
    let grid = PerspectiveGrid::new(RayBundle::Parallel(ahead), &alone).expect("a grid");
    let parallel = corners([-1.0, -1.0], [1.0, 1.0]).map(|corner| ray(corner.direction, ahead));
    assert_eq!(grid.may_miss_features(&parallel, 0.1), None);
    assert_eq!(
        grid.may_miss_features(&corners([-1.0, -1.0], [1.0, 1.0]), 0.1),
        None
    );
}

/// A needle along the diagonal of its bounds is narrower than the bounds.
#[test]
fn only_a_sphere_is_as_wide_as_its_bounds() {
    let (bounds, sphere) = cube(1.0, [0.0, 0.0, -10.5]);
    let hides = |shape| hides(&[(bounds, shape)], [-1.0, -1.0], 2.0, 0.01);
    assert!(!hides(sphere));
    for shape in [ShapeId::Other(0), ShapeId::Triangle(0), ShapeId::Box(0)] {
        assert!(hides(shape), "{shape:?}");
    }
}
