//! Rays in random worlds of mirrors, compared with the lesson's tracer.

use crate::prelude::*;

pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}

pub fn check(check: &mut Check, yours: &(dyn Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync)) {
    // To the background, to the floor, which mirrors it, and to the triangle.
    let ends = [[4.0, 3.0, 0.0], [4.0, -3.0, 0.0], [0.0, -2.5, -8.0]];
    let simple = [1, 2, 0, 5].map(|depth| {
        let ball = ([0.0, 1.0, 0.0], 1.0);
        ends.map(|d| (ball, [0.5, 0.5, 1.0], [[0.0, 4.0, 4.0], d], depth))
    });
    check.compare(
        "a ball around {} of radius {}, everything mirrors {}, ray from and along {}, depth {}",
        simple.concat(),
        random(|r| {
            let (ball, [x, y, _]) = ((r.triple(3.0), r.between(0.2, 2.0)), r.triple(3.0));
            let mirror = [(); 3].map(|()| r.between(0.1, 1.0));
            // From before the objects to a place among them.
            let (o, [u, v, w]) = ([x, y.abs() + 0.1, 6.0], r.triple(4.0));
            let d = point([u / 2.0, v.abs(), w - 4.0]) - point(o);
            (ball, mirror, [o, array(d)], r.below(7))
        }),
        [&trace as _, yours],
        |trace, ((c, r), mirror, [o, d], depth)| {
            let world = mirrors(c, r, mirror).ok()?;
            Some(trace(&world, &Ray::derived(point(o), unit(d)), depth).channels())
        },
    );
    check.scene(&stage(), "sphere", reflected_scene(scenes::sphere(), yours));
}

/// The recursion, whose reflected rays go along this direction.
fn reflected(
    direction: fn(&Ray, &Hit) -> Vector3,
) -> impl Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync {
    move |world, ray, depth| {
        let leaving = |ray: &Ray, hit: &Hit, _| secondary_ray(ray, hit, direction(ray, hit));
        Tracer(world, &is_shadowed, &leaving).trace(ray, depth)
    }
}

variants! { check:
    yours => &trace;
    right "the recursion" => &reflected(|ray, hit| (-ray.direction()).reflected_on(hit.normal));
    wrong "the last surface mirrors black" => &|world, ray, depth| trace(world, ray, depth + 1);
    wrong "a mirror is seen by its normal, not by its face" => &reflected(|ray, hit| {
        (-ray.direction()).reflected_on(hit.face)
    });
    wrong "the formula wants a vector away from the surface" => &reflected(|ray, hit| {
        ray.direction().reflected_on(hit.normal)
    });
}
