//! Matt surfaces, compared with the lesson's.

use crate::prelude::*;
use crate::solutions::lambert::lambert as lesson;

pub fn check(check: &mut Check, matt: impl Fn(Color, &Ray, &Hit, &dyn Lighting) -> Color + Sync) {
    compare_materials(
        check,
        "diffuse {}",
        &[1.0, 0.5, 0.0],
        channels,
        |diffuse, ray, hit, lights| lesson(color(diffuse), ray, hit, lights),
        |diffuse, ray, hit, lights| matt(color(diffuse), ray, hit, lights),
    );
    check.scene(&stage(), "lambert", shaded(scenes::lambert(), matt));
}

/// The sum over the lights, with this function of each cosine.
fn textbook(c: &mut Check, share: fn(f64) -> f64) {
    check(c, |diffuse, ray, hit, lights| {
        sum(diffuse, ray, hit, lights, |light| {
            diffuse * share(hit.normal.dot(light.direction)) * light.color
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("the share first", |c| textbook(c, |cosine| cosine.max(0.0))),
    wrong("no light is negative", |c| textbook(c, |cosine| cosine)),
];
