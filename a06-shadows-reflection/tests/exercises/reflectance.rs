//! Surfaces between all indices, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(f64, f64, f64) -> f64) {
    let index = |r: &mut Random| r.between(1.0, 2.5);
    check.compare(
        "cosine and indices {}",
        [[1.0, 2.0], [0.5, 2.0], [0.0, 2.0], [0.5, 0.5]].map(|[cosine, to]| [cosine, 1.0, to]),
        random(|r| [r.between(0.0, 1.0), index(r), index(r)]),
        [reflectance, yours],
        |reflectance, [cosine, from, to]| reflectance(cosine, from, to),
    );
    // Objects as of diamond.
    check.picture(rendered(scenes::sphere(), |world, ray, depth| {
        let (tracer, to_eye) = (RecursiveTracer::new(world), -ray.direction());
        let nearest = world.objects().hit(ray, Interval::AHEAD);
        nearest.map_or(Color::BLACK, |(hit, surface)| {
            let share = yours(to_eye.dot(hit.normal), 1.0, 2.4);
            let mirrored = secondary_ray(ray, &hit, to_eye.reflected_on(hit.normal));
            surface.color_for(ray, &hit, &tracer) + tracer.trace(&mirrored, depth) * share
        })
    }));
}

variants! { check:
    yours => reflectance;
    wrong "Schlick's formula is only near to Fresnel's" => |cosine, from, to| {
        let straight = reflectance(1.0, from, to);
        straight + (1.0 - straight) * libm::pow(1.0 - cosine, 5.0)
    };
    wrong "a share is the square of an amplitude" => |cosine, from, to| {
        reflectance(cosine, from, to).sqrt()
    };
    wrong "where no light gets through, all is mirrored" => |cosine, from, to| {
        reflectance(cosine, from, to) % 1.0
    };
}
