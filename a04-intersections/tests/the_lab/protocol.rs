//! The formulas of the protocol.
//!
//! On numbers without rounding the formulas are right: see also the rows of the table in
//! which they hold. Hits nearer than a thousandth do not count.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::protocol::{
    Compared, NEAREST, axis_aligned_box, interpolated_normal, is_inside_by_the_text, sphere,
    triangle,
};

fn ray(x: f64, y: f64, z: f64) -> Ray {
    Ray::derived(Point3::new(x, y, z), Vector3::new(0.0, 0.0, -1.0))
}

#[test]
fn a_box_is_met_beyond_the_nearest_distance() {
    let [lbf, run] = [Point3::new(-1.0, -1.0, -2.0), Point3::new(1.0, 1.0, 0.0)];
    for compared in [Compared::Three, Compared::Two] {
        let t = |z| axis_aligned_box(lbf, run, &ray(0.5, -0.5, z), compared);
        assert_eq!([t(3.0), t(-0.5), t(-2.5)], [Some(3.0), Some(1.5), None]);
        // As the nearer face is too near, the other one is met.
        assert_eq!([t(0.002), t(NEAREST)], [Some(0.002), Some(2.0 + NEAREST)]);
    }
}

#[test]
fn by_the_text_only_one_edge_is_inside() {
    assert!(is_inside_by_the_text(0.5, 0.5) && is_inside_by_the_text(0.25, 0.75));
    let outside = [[0.25, 0.25], [0.0, 1.0], [1.0, 0.0]].into_iter();
    for [beta, gamma] in outside.chain([[-1.0, 2.0], [2.0, -1.0], [2.0, 0.5]]) {
        assert!(!is_inside_by_the_text(beta, gamma));
    }
}

/// The corner a lies at the origin: the ray over (β, γ) meets it there.
#[test]
fn a_triangle_is_met_on_its_edges_but_not_at_its_first_corner() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    let t = |[beta, gamma]: [f64; 2], z| triangle(&corners, &ray(beta, gamma, z));
    for met in [[0.25, 0.5], [0.5, 0.5], [0.0, 0.5], [0.5, 0.0]] {
        assert_eq!(
            [t(met, 4.0), t(met, NEAREST), t(met, 0.0009)],
            [Some(4.0), Some(NEAREST), None]
        );
    }
    for missed in [[0.0, 0.0], [-0.25, 0.5], [0.5, -0.25], [0.75, 0.5]] {
        assert_eq!(t(missed, 4.0), None, "{missed:?}");
    }
}

#[test]
fn the_normal_between_the_corners_is_their_weighted_sum() {
    let normals = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    let between = interpolated_normal(normals.map(|n| Normal3::from_glam(n.into())), 0.25, 0.5);
    assert_eq!(between, Normal3::new(1.0, 1.0, 2.0));
}

/// All numbers are small multiples of the shortest distance or of 1, and
/// exact in every step.
#[test]
fn a_sphere_is_met_beyond_the_nearest_distance() {
    let x = f64::from(0.001_f32);
    let t = |r: f64, o: [f64; 3]| sphere(&[0.0; 3], r, &o, &[0.0, 0.0, -1.0]);
    assert_eq!(t(1.0, [2.0, 0.0, 3.0]), None);
    // Roots at 1 and 3 times the shortest distance, and at -1 and 1.
    assert_eq!(
        [t(x, [0.0, 0.0, 2.0 * x]), t(x, [0.0; 3])],
        [Some(3.0 * x), None]
    );
    // Tangents at the shortest distance, and behind.
    assert_eq!(
        [t(x, [x, 0.0, x]), t(1.0, [1.0, 0.0, -5.0])],
        [Some(x), None]
    );
}
