//! Surfaces between all indices, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(f64, f64, f64) -> f64) {
    check.compare(
        "cosine and indices {}",
        [
            [1.0, 1.0, 2.0],
            [0.5, 1.0, 2.0],
            [0.0, 1.0, 2.0],
            [0.5, 2.0, 1.0],
        ],
        random(|r| {
            [
                r.between(0.0, 1.0),
                r.between(1.0, 2.5),
                r.between(1.0, 2.5),
            ]
        }),
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

pub const VARIANTS: &[Variant] = &[
    wrong("Schlick's formula is only near to Fresnel's", |c| {
        check(c, |cosine, from, to| {
            let straight = reflectance(1.0, from, to);
            straight + (1.0 - straight) * libm::pow(1.0 - cosine, 5.0)
        });
    }),
    wrong("a share is the square of an amplitude", |c| {
        check(c, |cosine, from, to| reflectance(cosine, from, to).sqrt());
    }),
    wrong("where no light gets through, all is mirrored", |c| {
        check(c, |cosine, from, to| reflectance(cosine, from, to) % 1.0);
    }),
];
