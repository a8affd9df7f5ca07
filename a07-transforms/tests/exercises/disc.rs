//! Discs anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Normal3, f64) -> Made<Shape>) {
    compare(
        check,
        "disc around {}, normal {}, radius {}",
        ([0.0; 3], [0.0, 1.0, 0.0], 2.0),
        |r| (r.triple(3.0), r.triple(5.0), r.between(0.5, 4.0)),
        &|(c, n, r)| boxed(Disc::new(point(c), vector(n).as_normal(), r)),
        &|(c, n, r)| new(point(c), vector(n).as_normal(), r),
    );
    locked_scene(check, "disc", 8.0, ([8.0; 3], true, 0.1), |world| {
        let (half, up) = (Color::gray(0.5), Normal3::new(0.0, 1.0, 0.0));
        let red = Reflective::new(Color::RED, Color::BLACK, 64.0, half)?;
        let green = Reflective::new(Color::GREEN, Color::WHITE, 2000.0, half)?;
        let world = world.with(Plane::new(Point3::ORIGIN, up)?, Box::new(red));
        Ok(world.with(new(point([0.0, 0.001, 0.0]), up, 5.0)?, Box::new(green)))
    });
}

/// The hits of the plane that are on the disc, by their distance from the centre.
fn variant(c: &mut Check, is_on_disc: fn(f64, f64) -> bool) {
    check(c, &move |c, n, r| {
        let plane = Plane::new(c, n)?;
        own(move |ray: &Ray, i| {
            let hit = plane.hit(ray, i)?;
            is_on_disc((ray.at(hit.t) - c).magnitude(), r).then_some(hit)
        })
    });
}

variants! { variant:
    yours => &|c, n, r| shape::boxed(Disc::new(c, n, r));
    right "the distance, not its square" => |d, r| d <= r;
    wrong "the rim belongs to the disc" => |d, r| d < r;
}
