//! Surfaces between all indices, compared with the solution.

use crate::prelude::*;
use crate::solutions::reflectance::reflectance as solution;

pub fn check(check: &mut Check, reflectance: impl Fn(f64, f64, f64) -> f64 + Sync) {
    check.compare(
        "cosine {}, from the index {} to {}",
        [
            (1.0, 1.0, 2.0),
            (0.5, 1.0, 2.0),
            (0.0, 1.0, 2.0),
            (0.5, 2.0, 1.0),
        ],
        random(|r| {
            (
                r.between(0.0, 1.0),
                r.between(1.0, 2.5),
                r.between(1.0, 2.5),
            )
        }),
        |(cosine, from, to)| solution(cosine, from, to),
        |(cosine, from, to)| reflectance(cosine, from, to),
    );
    let up = Normal3::new(0.0, 1.0, 0.0);
    let lake = Plane::new(Point3::ORIGIN, up);
    show(
        check,
        [[0.0, 2.0, 6.0], [0.0, 0.9, 0.0]],
        lake,
        |lake, ray| {
            let d = ray.direction();
            if lake.hit(ray, Interval::AHEAD).is_none() {
                return checkered(d);
            }
            let share = reflectance(-d.dot(up), 1.0, 4.0 / 3.0);
            let depth = Color::new(0.0, 0.15, 0.2);
            depth * (1.0 - share) + checkered((-d).reflected_on(up)) * share
        },
    );
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
