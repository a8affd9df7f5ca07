//! A ball before, behind and beyond lights in worlds of all sizes, compared with the lesson.

use crate::prelude::*;

pub fn check(
    check: &mut Check,
    yours: &(dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Sync),
) {
    let lit = |y, r, distance| ([0.0; 3], ([0.0, y, 0.0], r), [0.0, 1.0, 0.0], distance);
    let simple = [
        lit(4.0, 1.0, 8.0),
        lit(4e-9, 1e-9, 8e-9),
        // Just before the lamp, beyond it, and the lamp's own.
        lit(7.96875, 0.015_625, 8.0),
        lit(12.0, 1.0, 8.0),
        lit(10.0, 2.0, 8.0),
        lit(12.0, 1.0, f64::INFINITY),
        lit(-4.0, 1.0, f64::INFINITY),
    ];
    check.compare(
        "floor y = 0 at {}, ball around {} of radius {}, lamp towards {} at the distance {}",
        simple,
        random(|r| {
            let size = [1e-6, 1.0, 1e6][r.below(3) as usize] * r.between(1.0, 9.0);
            let ([x, _, z], [u, v, w]) = (r.triple(1.0), r.triple(1.0));
            let (p, l) = (vector([x, 0.0, z]) * size, unit([u, v.abs() + 0.1, w]));
            // Where the ball begins and ends, as shares of the distance.
            let ends = [[0.2, 0.4], [0.992, 0.999], [1.0, 1.2], [1.1, 1.3]];
            let [from, to] = ends[r.below(4) as usize];
            let c = p + l * (size * f64::midpoint(from, to));
            let radius = size * (to - from) / 2.0;
            (array(p), (array(c), radius), array(l), size)
        }),
        [&is_shadowed as _, yours],
        |is_shadowed, (p, (c, r), to_light, distance)| {
            // The eye is beside the point, as far as the lamp or 1.
            let away = vector([3.0, 2.0, 1.0]) * if distance < 1e9 { distance } else { 1.0 };
            let ray = Ray::new(point(p) + away, -away).ok()?;
            let world = mirrors(c, r, [0.0; 3]).ok()?;
            let (hit, _) = world.objects().hit(&ray, Interval::AHEAD)?;
            let mut light = Illumination::default();
            (light.direction, light.distance) = (unit(to_light), distance);
            Some(is_shadowed(world.objects(), &ray, &hit, &light))
        },
    );
    let picture = reflected_scene(scenes::aab(), |world, ray, depth| {
        Tracer(world, yours, &secondary_ray).trace(ray, depth)
    });
    check.scene(&stage(), "aab", picture);
}

/// Whether anything is hit from the surface on, up to this distance.
fn up_to(c: &mut Check, end: fn(f64) -> f64) {
    check(c, &|world, ray, hit, light| {
        let to_light = secondary_ray(ray, hit, light.direction);
        let between = Interval::before(end(light.distance));
        world.hit(&to_light, between).is_some()
    });
}

variants! { up_to:
    yours => &is_shadowed;
    right "a nearest hit" => |d| d * (1.0 - 1e-6);
    wrong "objects beyond it cast none" => |_| 1e300;
    wrong "the lamp's ceiling blocks nothing" => |d| d;
    wrong "no length is fixed" => |d| d - 1e-6;
    wrong "an object before it is seen" => |d| d * 0.99;
}
