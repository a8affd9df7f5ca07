//! Surfaces between all indices, compared with the solution.

use crate::prelude::*;
use crate::solutions::reflectance::reflectance as solution;

pub fn check(check: &mut Check, reflectance: impl Fn(f64, f64, f64) -> f64 + Sync) {
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
        |[cosine, from, to]| solution(cosine, from, to),
        |[cosine, from, to]| reflectance(cosine, from, to),
    );
    // Objects as of diamond.
    check.picture(rendered(scenes::sphere(), |world, ray, depth| {
        let tracer = RecursiveTracer::new(world);
        let Some((hit, surface)) = world.objects().hit(ray, Interval::AHEAD) else {
            return world.objects().background();
        };
        let to_eye = -ray.direction();
        let share = reflectance(to_eye.dot(hit.normal), 1.0, 2.4);
        let mirrored = secondary_ray(ray, &hit, to_eye.reflected_on(hit.normal));
        surface.color_for(ray, &hit, &tracer) + tracer.trace(&mirrored, depth) * share
    }));
}

/// The share that follows from the amplitudes of both polarisations, or from none.
fn share(c: &mut Check, share: fn(Option<[f64; 2]>) -> f64) {
    check(c, |cosine, from, to| {
        let ratio = from / to;
        let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        share((squared > 0.0).then(|| {
            let amplitude = |a: f64, b: f64| (a - b) / (a + b);
            let beyond = squared.sqrt();
            [
                amplitude(from * cosine, to * beyond),
                amplitude(from * beyond, to * cosine),
            ]
        }))
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("Schlick's formula is only near to Fresnel's", |c| {
        check(c, |cosine, from, to| {
            let straight = solution(1.0, from, to);
            straight + (1.0 - straight) * libm::pow(1.0 - cosine, 5.0)
        });
    }),
    wrong("daylight is half of each polarisation", |c| {
        share(c, |both| both.map_or(1.0, |[across, _]| across * across));
    }),
    wrong("where no light gets through, all is mirrored", |c| {
        share(c, |both| {
            both.map_or(0.0, |[a, b]| f64::midpoint(a * a, b * b))
        });
    }),
];
