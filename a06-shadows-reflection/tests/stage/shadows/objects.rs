//! Which objects cast a shadow, and which do not.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Triangle};
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld};
use approx::assert_abs_diff_eq;

use super::{AMBIENT, LIT, floor, lamp, plane, point_light, seen, sphere, white};

#[test]
fn what_is_between_a_surface_and_a_light_casts_a_shadow() {
    for r in [1.0, 1e-3, 1e-9] {
        for y in [1.5, 4.0] {
            let world = floor()
                .with(sphere(0.0, y, 0.0, r), white())
                .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
            assert_eq!(seen(&world), AMBIENT, "a sphere of {r} at {y}");
        }
    }
    let aside = floor()
        .with(sphere(2.0, 4.0, 0.0, 1.0), white())
        .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
    assert_eq!(seen(&aside), LIT);
}

#[test]
fn every_shape_casts_a_shadow_from_both_of_its_sides() {
    let (lbf, run) = (Point3::new(-1.0, 2.0, -1.0), Point3::new(1.0, 3.0, 1.0));
    let [a, b, c] = [(-1.0, -1.0), (2.0, -1.0), (0.0, 2.0)].map(|(x, z)| Point3::new(x, 2.0, z));
    let lit = |world: ShadowedWorld| world.lit_by(lamp(point_light(0.0, 6.0, 0.0)));
    for world in [
        floor().with(AxisAlignedBox::new(lbf, run).unwrap(), white()),
        floor().with(Triangle::new(a, b, c).unwrap(), white()),
        floor().with(Triangle::new(a, c, b).unwrap(), white()),
        floor().with(plane(2.0), white()),
        floor().with(sphere(0.0, 6.0, 0.0, 2.0), white()),
    ] {
        assert_eq!(seen(&lit(world)), AMBIENT);
    }
}

#[test]
fn what_is_behind_the_light_or_below_the_surface_casts_none() {
    for (y, r) in [(8.0, 1.0), (6.001_001, 0.001), (-1.5, 1.0), (-0.002, 0.001)] {
        let world = floor()
            .with(sphere(0.0, y, 0.0, r), white())
            .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
        assert_eq!(seen(&world), LIT, "a sphere of {r} at {y}");
    }
}

/// A lamp that is fixed to the ceiling: it lies in the object, and lights the
/// room all the same, from wherever that is seen and however low the ceiling.
/// A ceiling a millionth lower hides the lamp.
///
/// Tolerance: the eye looks at a slope of 0.3 / 1000 at most, so that the place
/// it sees is wrong by up to 1e4 eps of its distance, and the cosine by as much
/// relative to the height: 1e7 eps.
#[test]
fn an_object_at_the_light_itself_is_not_in_its_way() {
    for height in [1e-3, 1.0, 6.0, 1e3] {
        for distance in [height, 30.0 * height, 1e3 * height] {
            for (x, z) in [
                (0.0, 0.0),
                (0.3, -0.7),
                (-1.0, 0.1),
                (5.0, 0.0),
                (-9.0, 30.0),
            ] {
                // The eye is below the ceiling, and looks at the floor aslant.
                let place = Point3::new(x * height, 0.0, z * height);
                let eye = place + Vector3::new(0.6 * distance, 0.3 * height, -0.8 * distance);
                let ray = Ray::new(eye, place - eye).unwrap();
                let cosine = 1.0 / (1.0 + x * x + z * z).sqrt();
                for (ceiling, lit) in [(1.0, cosine), (1.0 - 1e-6, 0.0)] {
                    let world = floor()
                        .with(plane(ceiling * height), white())
                        .lit_by(lamp(point_light(0.0, height, 0.0)));
                    let color = RecursiveTracer::new(&world).trace(&ray, 1);
                    assert_abs_diff_eq!(color.r, 0.25 + lit, epsilon = 1e7 * f64::EPSILON);
                }
            }
        }
    }
}
