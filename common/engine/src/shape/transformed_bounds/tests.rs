//! Tests of `transformed_bounds`. Bounds that are too large change no picture, only its
//! time; so they are tested by themselves. Bounds that are too small lose hits of the lesson, which
//! the tests of stage 7 notice.

use std::f64::consts::FRAC_PI_4;

use glam::{DMat4, DVec3};

use super::*;
use crate::shape::{AxisAlignedBox, Disc, Plane, Primitive, Shape, Sphere};

/// From -1 to 1 along each axis.
const CUBE: AxisAlignedBox = AxisAlignedBox {
    min: [-1.0; 3],
    max: [1.0; 3],
};

const BALL: Sphere = Sphere {
    center: DVec3::ZERO,
    radius: 1.0,
};

/// A shape under transforms, the innermost first.
fn under<'a>(shape: Shape<'a>, matrices: &[DMat4]) -> Shape<'a> {
    matrices.iter().fold(shape, |shape, matrix| {
        shape.transformed(&Transform::new(*matrix, matrix.inverse()))
    })
}

fn bounds(shape: &Shape) -> Bounds {
    match shape {
        Shape::Transformed(shape) => shape.bounds(),
        _ => unreachable!("it has a transform"),
    }
}

fn translated(x: f64, y: f64, z: f64) -> DMat4 {
    DMat4::from_translation(DVec3::new(x, y, z))
}

fn scaled(x: f64, y: f64, z: f64) -> DMat4 {
    DMat4::from_scale(DVec3::new(x, y, z))
}

/// The bounds hold the shape, with room for the 4096 units of rounding for each transform that a
/// hit may be off; and with no more than a hundred times as much.
fn assert_fits(shape: Shape, matrices: &[DMat4], min: [f64; 3], max: [f64; 3]) {
    let bounds = bounds(&under(shape, matrices));
    let largest = min.iter().chain(&max).fold(0.0, |a: f64, x| a.max(x.abs()));
    let room = 4096.0 * f64::EPSILON * largest * matrices.len() as f64;
    for axis in 0..3 {
        for beyond in [min[axis] - bounds.min[axis], bounds.max[axis] - max[axis]] {
            let fits = (room..100.0 * room).contains(&beyond);
            assert!(fits, "axis {axis}: {beyond:e} beyond, not {room:e}");
        }
    }
}

#[test]
fn bounds_are_moved_and_stretched_with_the_shape() {
    let cube = || Shape::Box(CUBE);
    assert_fits(cube(), &[DMat4::IDENTITY], [-1.0; 3], [1.0; 3]);
    let moved = translated(10.0, -20.0, 30.0);
    assert_fits(cube(), &[moved], [9.0, -21.0, 29.0], [11.0, -19.0, 31.0]);
    let stretched = moved * scaled(2.0, -3.0, 0.5);
    assert_fits(
        cube(),
        &[stretched],
        [8.0, -23.0, 29.5],
        [12.0, -17.0, 30.5],
    );
}

/// On its edge a cube of half width 1 is √2 high, and on its corner √2 + √½ √2 wide: its
/// extents are the sums of the rows' magnitudes. Bounds of bounds would grow with each transform:
/// four eighths of a turn make a half.
#[test]
fn a_rotated_cube_has_the_bounds_of_its_corners() {
    let root = 2_f64.sqrt();
    let [about_x, about_z] = [DMat4::from_rotation_x, DMat4::from_rotation_z].map(|f| f(FRAC_PI_4));
    for (matrices, [x, y, z]) in [
        (&[about_z][..], [root, root, 1.0]),
        (
            &[about_z * about_x],
            [root / 2.0 + 1.0, root / 2.0 + 1.0, root],
        ),
        (
            &[about_x, about_z],
            [root / 2.0 + 1.0, root / 2.0 + 1.0, root],
        ),
        (&[about_z; 4], [1.0; 3]),
    ] {
        assert_fits(Shape::Box(CUBE), matrices, [-x, -y, -z], [x, y, z]);
    }
}

/// A sphere that is stretched by a, b and c, and then turned by an eighth about the z axis,
/// reaches √((a² + b²)/2), the same, and c. A disc reaches along an axis as far as the sine of the
/// angle between axis and normal: with the normal (3, 4, 0) / 5 that is 4/5, 3/5 and 1.
#[test]
fn ellipsoids_and_discs_have_their_own_bounds_and_not_those_of_a_box() {
    let matrices = [scaled(7.0, 1.0, 2.0), DMat4::from_rotation_z(FRAC_PI_4)];
    assert_fits(
        Shape::Sphere(BALL),
        &matrices,
        [-5.0, -5.0, -2.0],
        [5.0, 5.0, 2.0],
    );
    let plane = Plane {
        point: DVec3::new(1.0, 2.0, 3.0),
        normal: DVec3::new(0.6, 0.8, 0.0),
    };
    let radius = 10.0;
    let disc = Shape::Disc(Disc { plane, radius });
    let matrices = [scaled(2.0, 1.0, -1.0)];
    assert_fits(disc, &matrices, [-14.0, -4.0, -13.0], [18.0, 8.0, 7.0]);
}

/// Rounding moves a hit by up to 2^20 units in a space that is stretched 2^20 times as
/// far in one direction as in another; beyond that no bounds are sure.
#[test]
fn very_unequal_stretching_and_planes_have_no_bounds() {
    let stretched = |x: f64| bounds(&under(Shape::Box(CUBE), &[scaled(x, 1.0, 1.0)]));
    assert!(stretched(1_048_576.0).are_finite());
    assert_eq!(stretched(1_048_577.0), Bounds::EVERYWHERE);
    let (point, normal) = (DVec3::ZERO, DVec3::Y);
    let plane = Shape::Plane(Plane { point, normal });
    let moved = under(plane, &[translated(1.0, 2.0, 3.0)]);
    assert_eq!(bounds(&moved), Bounds::EVERYWHERE);
}
