//! Spheres: where rays enter and leave. Spheres from far away, from their surface and along
//! their border are the extreme cases A01 to A22 and S10.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Sphere};
use approx::assert_abs_diff_eq;

use crate::test_shapes::{point, random_vector};

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

/// A ray that starts in the middle of its chord, where both roots are as far away.
#[test]
fn the_sign_of_a_zero_moves_no_hit() {
    let sphere = Sphere::new(point([0.0, 0.0, 0.6]), 1.0).unwrap();
    for zero in [0.0, -0.0] {
        let ray = Ray::new(point([zero, zero, 0.0]), Vector3::new(1.0, 0.0, 0.0)).unwrap();
        let hit = sphere.hit(&ray, Interval::AHEAD).unwrap();
        assert_eq!(hit.t, 0.8, "{zero:?}");
    }
}
