//! The formulas of the protocol.
//!
//! On whole numbers the formulas are right, so that only the extreme
//! cases make them fail. The test `the_errata` locks pictures by the inverse of a chain and
//! by the last hit.

use a02_math::{Normal3, Point3, Vector3};
use a04_intersections::lab::extremes::raw_ray;
use a07_transforms::Transform;
use a07_transforms::protocol::{
    determinant_by_sarrus, disc, normal_as_point, normal_as_vector, product, scaled_direction,
    translation_in_last_row, transposed_normal, unnormalized_normal,
};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

fn step(to: [f64; 3], by: [f64; 3]) -> Transform {
    let moved = Transform::IDENTITY.translate(Point3::from_glam(to.into()));
    let [x, y, z] = by;
    moved.and_then(|t| t.scale(x, y, z)).unwrap()
}

/// Stretched three times along x, a surface that faces (4, 3) then faces
/// (4, 9), which none of them finds.
#[test]
fn normals_are_moved_as_the_texts_say() {
    let m = step([1.0, 2.0, 0.0], [3.0, 1.0, 1.0]).matrix();
    let n = Normal3::new(0.8, 0.6, 0.0);
    for (moved, x, y) in [
        (normal_as_vector(m, n), 2.4, 0.6),
        (transposed_normal(m, n), 2.4, 0.6),
        (normal_as_point(m, n), 3.4, 2.6),
    ] {
        let expected = Normal3::new(x, y, 0.0).normalized();
        let epsilon = 4.0 * f64::EPSILON;
        approx::assert_abs_diff_eq!(moved.unwrap(), expected.unwrap(), epsilon = epsilon);
    }
    // Twice as large, half as long.
    let halved = unnormalized_normal(step([0.0; 3], [2.0; 3]).inverse(), UP);
    assert_eq!(halved, Vector3::new(0.0, 0.5, 0.0));
    let scaled = scaled_direction([2.0, 4.0, 0.5], Vector3::new(3.0, 5.0, 7.0));
    assert_eq!(scaled, Vector3::new(1.5, 1.25, 14.0));
}

#[test]
fn translations_are_lost_and_factors_exchanged() {
    let matrix = translation_in_last_row(Point3::new(1.0, 2.0, 3.0));
    assert_eq!(matrix.rows()[3], [1.0, 2.0, 3.0, 1.0]);
    let [a, b] = [([1.0, 2.0, 3.0], [2.0; 3]), ([5.0, 0.0, 0.0], [1.0; 3])];
    let [a, b] = [a, b].map(|(to, by)| step(to, by).matrix());
    assert_eq!(product(a, b), b * a);
    assert_ne!(product(a, b), a * b);
}

/// Diagonals count, shifted by some columns, too, and mirrored as negative; other
/// products, an exchange of two columns for example, do not.
#[test]
fn sarrus_sees_eight_products_of_four_rows() {
    let places = |columns: [usize; 4]| {
        let mut rows = [[0.0; 4]; 4];
        for (row, column) in columns.into_iter().enumerate() {
            rows[row][column] = [2.0, 3.0, 5.0, 7.0][row];
        }
        determinant_by_sarrus(rows)
    };
    for first in 0..4 {
        let down = [0, 1, 2, 3].map(|i| (first + i) % 4);
        let up = [0, 1, 2, 3].map(|i| (first + 4 - i) % 4);
        assert_eq!((places(down), places(up)), (210.0, -210.0));
    }
    assert_eq!(places([1, 0, 2, 3]), 0.0);
}

/// 3² + 4² = 5², and the rim does not belong to it.
#[test]
fn a_disc_ends_before_its_rim() {
    let t = |o: [f64; 3], d: [f64; 3]| disc(Point3::ORIGIN, UP, 5.0, &raw_ray((o, d)));
    let at = |z| t([3.0, 2.0, z], [0.0, -4.0, 0.0]);
    assert_eq!([at(3.9), at(4.0), at(4.1)], [Some(0.5), None, None]);
    assert_eq!(t([0.0, 2.0, 0.0], [0.0, 1.0, 0.0]), None, "behind");
    assert_eq!(t([0.0; 3], [0.0, -1.0, 0.0]), None, "leaving");
    assert_eq!(t([0.0; 3], [1.0, 0.0, 0.0]), None, "within");
    assert_eq!(
        t([0.0, -1.0, 0.0], [1.0, 1.0, 0.0]),
        Some(1.0),
        "from below"
    );
}
