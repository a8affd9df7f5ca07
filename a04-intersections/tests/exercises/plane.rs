//! Planes anywhere, met from both sides, missed behind the ray, and along the plane.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::aimed::{Shown, alone, expect_scene, frame, point};

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3) -> Result<G, ArgumentError>,
) {
    let (floor, up) = (Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0));
    if let Ok(plane) = new(floor, up) {
        let words = "plane through [0, -1, 0] with normal [0, 1, 0]".to_owned();
        let plane = Shown {
            shape: &plane,
            words,
        };
        let ray = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, -0.5, 0.0));
        plane.expect(
            check,
            "straight down",
            &ray,
            Interval::AHEAD,
            Some((2.0, up)),
        );
    }
    let mut random = Random::new(42);
    for _ in 0..20 {
        let (a, [n, side, other]) = (point(&mut random, 5.0), frame(&mut random));
        let length = random.between(0.2, 5.0);
        let Ok(plane) = new(a, n.as_normal() * length) else {
            continue;
        };
        let words = format!(
            "plane through {} with normal {:.3}",
            a.to_glam(),
            (n * length).to_glam()
        );
        let plane = Shown {
            shape: &plane,
            words,
        };
        let at = a + side * random.between(-5.0, 5.0) + other * random.between(-5.0, 5.0);
        let aside = side * random.between(-2.0, 2.0);
        let front = at + n * random.between(0.5, 4.0) + aside;
        let back = at - n * random.between(0.5, 4.0) + aside;
        plane.expect_nearest(
            check,
            "from the side of the normal",
            front,
            at,
            n.as_normal(),
        );
        plane.expect_nearest(check, "from the far side", back, at, n.as_normal());
        plane.expect_none(check, "the plane lies behind", front, front - at);
    }
    // Exactly parallel: the coordinates are whole.
    if let Ok(plane) = new(floor, up) {
        let words = "plane through [0, -1, 0] with normal [0, 1, 0]".to_owned();
        let plane = Shown {
            shape: &plane,
            words,
        };
        let along = Vector3::new(3.0, 0.0, 1.0);
        plane.expect_none(check, "parallel to the plane", Point3::ORIGIN, along);
        plane.expect_none(check, "in the plane", Point3::new(4.0, -1.0, 2.0), along);
    }
    expect_scene(check, "scene-1", || alone(new(floor, up)?, Color::GREEN));
}
