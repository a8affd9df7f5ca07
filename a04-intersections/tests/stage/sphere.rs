//! Spheres: from near, from inside and along their border. Spheres far away are the extreme
//! cases A01 to A06 and S10, and the chord of a ray just inside the border is A21.

use a02_math::{Direction, Point3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Sphere};
use approx::assert_abs_diff_eq;

use super::support::{assert_hits, point, random_vector};

const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];
const TOWARDS: [f64; 3] = [0.0, 0.0, 1.0];
const RIGHT: [f64; 3] = [1.0, 0.0, 0.0];

#[test]
fn a_sphere_is_hit_in_front_from_inside_and_along_its_border() {
    let (above, below) = (1_f64.next_up(), -1_f64.next_up());
    assert_hits(
        &Sphere::new(Point3::ORIGIN, 1.0).unwrap(),
        &[
            ([0.0, 0.0, 3.0], AHEAD, Some((2.0, TOWARDS))),
            ([0.0, 0.0, 0.5], AHEAD, Some((1.5, AHEAD))),
            ([0.0, 0.0, 0.0], AHEAD, Some((1.0, AHEAD))),
            ([0.0, 0.0, -0.5], AHEAD, Some((0.5, AHEAD))),
            // From its surface: inwards, outwards, along it.
            ([0.0, 0.0, 1.0], AHEAD, Some((2.0, AHEAD))),
            ([0.0, 0.0, -1.0], AHEAD, None),
            ([1.0, 0.0, 0.0], AHEAD, None),
            // Behind, and beside.
            ([0.0, 0.0, -3.0], AHEAD, None),
            ([1.1, 0.0, 5.0], AHEAD, None),
            // Tangents belong to the sphere, and rounding does not widen it.
            ([-5.0, 1.0, 0.0], RIGHT, Some((5.0, [0.0, 1.0, 0.0]))),
            ([-5.0, above, 0.0], RIGHT, None),
            ([-5.0, below, 0.0], RIGHT, None),
        ],
    );
}

/// Bound: 4 eps of the distance or the radius, whichever is greater, for the
/// formula, and as much for the direction, for `at` and for checking. Along the
/// ray it is more by the cosine, away from the surface not.
#[test]
fn both_hits_lie_on_the_sphere_with_normals_from_the_centre() {
    let (c, r) = (point([3.0, -2.0, 0.5]), 1.75);
    let sphere = Sphere::new(c, r).unwrap();
    let mut hits = [0; 2];
    for n in 0..5000 {
        let random = PixelRandom::new(2, n, 0);
        let o = Point3::ORIGIN + random_vector(random, 0, 10.0);
        let ray = Ray::new(o, c + random_vector(random, 3, 1.5) - o).unwrap();
        let mut within = Interval::AHEAD;
        for _ in 0..2 {
            let Some(found) = sphere.hit(&ray, within) else {
                break;
            };
            within.min = found.t;
            let from_centre = ray.at(found.t) - c;
            let bound = 8.0 * f64::EPSILON * (o - c).magnitude().max(r);
            let cosine = found.normal.dot(ray.direction());
            assert_abs_diff_eq!(from_centre.magnitude(), r, epsilon = bound);
            let normal = (from_centre * (1.0 / r)).as_normal();
            assert_abs_diff_eq!(found.normal, normal, epsilon = bound / cosine.abs() / r);
            hits[usize::from(cosine > 0.0)] += 1;
        }
        let is_outside = (o - c).magnitude() > r;
        assert!(is_outside || hits[1] > 0);
    }
    // Rays that enter also leave; those from inside only leave.
    assert!(hits[0] > 2000 && hits[1] > hits[0], "{hits:?}");
}
