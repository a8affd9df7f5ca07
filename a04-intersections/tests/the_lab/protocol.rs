//! The formulas of the protocol.
//!
//! On numbers without rounding the formulas are right, so that only the extreme
//! cases make them fail.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::protocol::{
    Compared, NEAREST, axis_aligned_box, interpolated_normal, is_inside_by_the_text, sphere,
    triangle,
};

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn ray(x: f64, y: f64, z: f64) -> Ray {
    Ray::derived(Point3::new(x, y, z), AHEAD)
}

#[test]
fn a_box_is_met_beyond_the_nearest_distance() {
    let [lbf, run] = [Point3::new(-1.0, -1.0, -2.0), Point3::new(1.0, 1.0, 0.0)];
    for compared in [Compared::Three, Compared::Two] {
        let t = |z| axis_aligned_box(lbf, run, &ray(0.5, -0.5, z), compared);
        assert_eq!((t(3.0), t(-0.5), t(-2.5)), (Some(3.0), Some(1.5), None));
        // As the nearer face is too near, the other one is met.
        assert_eq!(t(0.002), Some(0.002));
        assert_eq!(t(NEAREST), Some(2.0 + NEAREST));
    }
}

#[test]
fn by_the_text_only_one_edge_is_inside() {
    for (beta, gamma, inside) in [
        (0.5, 0.5, true),
        (0.25, 0.75, true),
        (0.25, 0.25, false),
        (0.0, 1.0, false),
        (1.0, 0.0, false),
        (-1.0, 2.0, false),
        (2.0, -1.0, false),
        (2.0, 0.5, false),
    ] {
        assert_eq!(is_inside_by_the_text(beta, gamma), inside);
    }
}

/// The corner a lies at the origin: the ray over (β, γ) meets it there.
#[test]
fn a_triangle_is_met_on_its_edges_but_not_at_its_first_corner() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    let t = |beta, gamma, z| triangle(&corners, &ray(beta, gamma, z));
    for (beta, gamma, z, met) in [
        (0.25, 0.5, 4.0, true),
        (0.5, 0.5, 4.0, true),
        (0.0, 0.5, 4.0, true),
        (0.5, 0.0, 4.0, true),
        (0.25, 0.5, NEAREST, true),
        (0.25, 0.5, 0.0009, false),
        (0.0, 0.0, 4.0, false),
        (-0.25, 0.5, 4.0, false),
        (0.5, -0.25, 4.0, false),
        (0.75, 0.5, 4.0, false),
    ] {
        assert_eq!(t(beta, gamma, z), met.then_some(z), "{beta}, {gamma}, {z}");
    }
}

#[test]
fn the_normal_between_the_corners_is_their_weighted_sum() {
    let normals = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    let normals = normals.map(|n| Normal3::from_glam(n.into()));
    assert_eq!(
        interpolated_normal(normals, 0.25, 0.5),
        Normal3::new(1.0, 1.0, 2.0)
    );
}

/// All numbers are small multiples of the shortest distance or of 1, and
/// exact in every step.
#[test]
fn a_sphere_is_met_beyond_the_nearest_distance() {
    let x = f64::from(0.001_f32);
    let t = |r: f64, o: [f64; 3]| sphere(&[0.0; 3], r, &o, &[0.0, 0.0, -1.0]);
    for (r, o, expected) in [
        (1.0, [0.0, 0.0, 3.0], Some(2.0)),
        (1.0, [0.0, 0.0, 0.0], Some(1.0)),
        (1.0, [0.0, 0.0, -3.0], None),
        (1.0, [2.0, 0.0, 3.0], None),
        // Roots at 1 and 3 times the shortest distance, and at -1 and 1.
        (x, [0.0, 0.0, 2.0 * x], Some(3.0 * x)),
        (x, [0.0, 0.0, 0.0], None),
        // Tangents ahead, at the shortest distance, and behind.
        (1.0, [1.0, 0.0, 5.0], Some(5.0)),
        (x, [x, 0.0, x], Some(x)),
        (1.0, [1.0, 0.0, -5.0], None),
    ] {
        assert_eq!(t(r, o), expected, "{r}, {o:?}");
    }
}
