//! Rays that leave a surface: where they start. That none hits its own surface again, and
//! none skips an object nearby, is shown by the experiments `acne` and `leaks`.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a06_shadows_reflection::secondary_ray;
use approx::assert_abs_diff_eq;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// Along the face, not the shading normal. The offset is 64 eps of the greatest of: `t`, 5
/// here, the coordinates of origin and hit, and the hit's scale.
#[test]
fn a_secondary_ray_starts_on_the_side_to_which_it_goes() {
    let leaning = Vector3::new(0.6, 0.8, 0.0).as_normal();
    let along_x = |x| Point3::new(x, 0.0, 0.0);
    for (eye, place, scale, greatest) in [
        (Point3::new(3.0, 4.0, 0.0), Point3::ORIGIN, 0.0, 5.0),
        (along_x(3.0), along_x(-2.0), 4.0, 5.0),
        (along_x(3.0), along_x(8.0), 4.0, 8.0),
        (along_x(-9.0), along_x(-4.0), 4.0, 9.0),
        (along_x(3.0), along_x(-2.0), 6e6, 6e6),
    ] {
        let hit = Hit {
            normal: leaning,
            ..Hit::new(5.0, UP.as_normal()).with_scale(scale)
        };
        let ray = Ray::new(eye, place - eye).unwrap();
        for (direction, side) in [
            (Vector3::new(0.6, 0.8, 0.0), 1.0),
            (Vector3::new(-1.0, 1e-300, 0.0), 1.0),
            (Vector3::new(0.6, -0.8, 0.0), -1.0),
        ] {
            let leaving = secondary_ray(&ray, &hit, direction);
            assert_eq!(leaving.direction(), direction);
            let offset = leaving.origin() - ray.at(5.0);
            let expected = UP * (side * 64.0 * f64::EPSILON * greatest);
            assert_abs_diff_eq!(offset, expected, epsilon = 4.0 * f64::EPSILON);
        }
    }
}
