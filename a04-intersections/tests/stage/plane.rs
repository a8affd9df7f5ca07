//! Planes: closed forms, and rays that miss. Grazing rays are the extreme cases B01 to B03.

use a02_math::{Normal3, Point3};
use a04_intersections::Plane;

use super::support::{assert_hits, point};

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const UP: [f64; 3] = [0.0, 1.0, 0.0];
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

#[test]
fn a_plane_is_hit_from_both_sides_with_its_own_unit_normal() {
    for length in [1e-200, 0.25, 1.0, 1e200] {
        let floor = Plane::new(point(DOWN), UPWARDS * length).unwrap();
        assert_hits(
            &floor,
            &[
                ([7.0, 3.0, -2.0], DOWN, Some((4.0, UP))),
                ([0.0, -3.5, 0.0], UP, Some((2.5, UP))),
                // A triangle of sides 3, 4 and 5.
                ([0.0, 3.0, 0.0], [3.0, -4.0, 0.0], Some((1.0, UP))),
                // Behind the origin.
                ([0.0; 3], UP, None),
                ([0.0, -2.0, 0.0], DOWN, None),
                // From the plane.
                ([3.0, -1.0, 4.0], UP, None),
                ([3.0, -1.0, 4.0], DOWN, None),
                ([3.0, -1.0, 4.0], [1.0, -1.0, 2.0], None),
            ],
        );
    }
}

#[test]
fn parallel_rays_miss() {
    let floor = Plane::new(Point3::ORIGIN, UPWARDS).unwrap();
    for zero in [0.0, -0.0] {
        let parallel = |y| ([0.0, y, 0.0], [1.0, zero, zero], None);
        assert_hits(&floor, &[1.0, zero, -3.0].map(parallel));
    }
}
