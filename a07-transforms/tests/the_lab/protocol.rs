//! The formulas of the protocol.
//!
//! On whole numbers the formulas are right, so that only the extreme
//! cases make them fail.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Sphere};
use a07_transforms::Transform;
use a07_transforms::protocol::{
    Chained, determinant_by_sarrus, disc, last_hit, normal_as_point, normal_as_vector, product,
    scaled_direction, translation_in_last_row, transposed_normal, unnormalized_normal,
};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

fn step(to: [f64; 3], by: [f64; 3]) -> Transform {
    let moved = Transform::IDENTITY.translate(Point3::from_glam(to.into()));
    let [x, y, z] = by;
    moved.and_then(|t| t.scale(x, y, z)).unwrap()
}

/// The point 1 is doubled and then moved by 4, to 6. The way back halves 6
/// before it moves, and ends at -1.
#[test]
fn the_inverse_of_a_chain_is_in_the_wrong_order() {
    let chained = Chained::IDENTITY
        .then(&step([4.0, 0.0, 0.0], [1.0; 3]))
        .then(&step([0.0; 3], [2.0; 3]));
    let x = Point3::new(1.0, 0.0, 0.0);
    assert_eq!(chained.m * x, Point3::new(6.0, 0.0, 0.0));
    assert_eq!(
        chained.i * Point3::new(6.0, 0.0, 0.0),
        Point3::new(-1.0, 0.0, 0.0)
    );
}

/// Stretched three times along x, a surface that faces (4, 3) then faces
/// (4, 9), which none of them finds.
#[test]
fn normals_are_moved_as_the_texts_say() {
    let transform = step([1.0, 2.0, 0.0], [3.0, 1.0, 1.0]);
    let (m, i) = (transform.matrix(), transform.inverse());
    let n = Normal3::new(0.8, 0.6, 0.0);
    let towards = |x, y| Normal3::new(x, y, 0.0).normalized();
    let close = |a: Option<Normal3>, b: Option<Normal3>| {
        approx::assert_abs_diff_eq!(a.unwrap(), b.unwrap(), epsilon = 4.0 * f64::EPSILON);
    };
    close(normal_as_vector(m, n), towards(2.4, 0.6));
    close(transposed_normal(m, n), towards(2.4, 0.6));
    close(normal_as_point(m, n), towards(3.4, 2.6));
    // Twice as large, half as long.
    assert_eq!(
        unnormalized_normal(step([0.0; 3], [2.0; 3]).inverse(), UP),
        Vector3::new(0.0, 0.5, 0.0)
    );
    assert_eq!(i * Vector3::new(3.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
    assert_eq!(
        scaled_direction([2.0, 4.0, 0.5], Vector3::new(3.0, 5.0, 7.0)),
        Vector3::new(1.5, 1.25, 14.0)
    );
}

#[test]
fn a_translation_in_the_last_row_moves_nothing() {
    let matrix = translation_in_last_row(Point3::new(1.0, 2.0, 3.0));
    assert_eq!(matrix.rows()[3], [1.0, 2.0, 3.0, 1.0]);
    assert_eq!(matrix * Point3::ORIGIN, Point3::ORIGIN);
}

#[test]
fn factors_change_places() {
    let (a, b) = (
        step([1.0, 2.0, 3.0], [2.0; 3]),
        step([5.0, 0.0, 0.0], [1.0; 3]),
    );
    assert_eq!(product(a.matrix(), b.matrix()), b.matrix() * a.matrix());
    assert_ne!(product(a.matrix(), b.matrix()), a.matrix() * b.matrix());
}

/// Of a diagonal matrix one diagonal is left, of the one with each row moved
/// one place to the right, too; mirrored, they count as negative. Of all
/// others, as of the even exchange of two pairs, nothing is found.
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

/// The nearest is found only if it is the last.
#[test]
fn of_several_hits_the_last_wins() {
    let sphere = |distance: f64| -> Box<dyn Geometry> {
        Box::new(Sphere::new(Point3::new(0.0, 0.0, -distance - 1.0), 1.0).unwrap())
    };
    let ahead = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, 0.0, -1.0));
    let last = |distances: &[f64]| {
        let children: Vec<_> = distances.iter().map(|d| sphere(*d)).collect();
        last_hit(&children, &ahead).map(|hit| hit.t)
    };
    assert_eq!(last(&[]), None);
    assert_eq!(last(&[3.0, 2.0]), Some(2.0));
    assert_eq!(last(&[2.0, 3.0]), Some(3.0));
    assert_eq!(last(&[3.0, 2.0, 5.0]), Some(5.0));
    assert_eq!(last(&[3.0, -9.0]), Some(3.0));
}

/// 3² + 4² = 5², and the rim does not belong to it.
#[test]
fn a_disc_ends_before_its_rim() {
    let at = |x: f64, z: f64| {
        let ray = Ray::derived(Point3::new(x, 2.0, z), Vector3::new(0.0, -4.0, 0.0));
        disc(Point3::ORIGIN, UP, 5.0, &ray)
    };
    assert_eq!(
        (at(3.0, 3.9), at(3.0, 4.0), at(3.0, 4.1)),
        (Some(0.5), None, None)
    );
    let aim = |y, d: [f64; 3]| {
        let ray = Ray::derived(Point3::new(0.0, y, 0.0), Vector3::from_glam(d.into()));
        disc(Point3::ORIGIN, UP, 5.0, &ray)
    };
    assert_eq!(aim(2.0, [0.0, 1.0, 0.0]), None, "behind");
    assert_eq!(aim(0.0, [0.0, -1.0, 0.0]), None, "leaving");
    assert_eq!(aim(0.0, [1.0, 0.0, 0.0]), None, "within");
    assert_eq!(aim(-1.0, [1.0, 1.0, 0.0]), Some(1.0), "from below");
}
