//! Shiny surfaces, compared with the lesson's.

use crate::prelude::*;
use crate::solutions::phong::phong as lesson;

pub fn check(
    check: &mut Check,
    shiny: impl Fn([Color; 2], f64, &Ray, &Hit, &dyn Lighting) -> Color + Sync,
) {
    compare_materials(
        check,
        "diffuse and specular {}, exponent {}",
        &([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], 2.0),
        |r| ([channels(r), channels(r)], r.between(0.5, 40.0)),
        |(colors, p), ray, hit, lights| lesson(colors.map(color), p, ray, hit, lights),
        |(colors, p), ray, hit, lights| shiny(colors.map(color), p, ray, hit, lights),
    );
    scene_of(
        check,
        "phong",
        a05_lighting::scenes::phong(),
        |d, ray, hit, lights| shiny([d, Color::WHITE], 64.0, ray, hit, lights),
    );
}

/// The sum over the lights, with this highlight of eye, light, normal and exponent.
fn textbook(c: &mut Check, highlight: fn(Vector3, Vector3, Normal3, f64) -> f64) {
    check(c, |[diffuse, specular], p, ray, hit, lights| {
        sum(diffuse, ray, hit, lights, |light| {
            let (n, l) = (hit.normal, light.direction);
            let highlight = highlight(-ray.direction(), l, n, p);
            (diffuse * n.dot(l).max(0.0) + specular * highlight) * light.color
        })
    });
}

/// This cosine, for light from before.
fn before(l: Vector3, n: Normal3, cosine: f64) -> f64 {
    if n.dot(l) > 0.0 {
        cosine.clamp(0.0, 1.0)
    } else {
        0.0
    }
}

pub const VARIANTS: &[Variant] = &[
    right("the eye mirrored in the place of the light", |c| {
        textbook(c, |e, l, n, p| {
            libm::pow(before(l, n, l.dot(e.reflected_on(n))), p)
        });
    }),
    wrong("light from behind has no highlight", |c| {
        textbook(c, |e, l, n, p| {
            libm::pow(e.dot(l.reflected_on(n)).clamp(0.0, 1.0), p)
        });
    }),
    wrong("an exponent may be a fraction", |c| {
        textbook(c, |e, l, n, p| {
            libm::pow(before(l, n, e.dot(l.reflected_on(n))), p.trunc())
        });
    }),
    wrong("the eye is where the ray comes from", |c| {
        textbook(c, |e, l, n, p| {
            libm::pow(before(l, n, -e.dot(l.reflected_on(n))), p)
        });
    }),
];
