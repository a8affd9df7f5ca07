//! Matt surfaces, compared with the lesson's.

use crate::prelude::*;

pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let matt = Lambert::new(diffuse);
    matt.map_or(Color::BLACK, |matt| matt.color_for(ray, hit, lighting))
}

pub fn check(
    check: &mut Check,
    yours: &(dyn Fn(Color, &Ray, &Hit, &dyn Lighting) -> Color + Sync),
) {
    compare_materials(
        check,
        "diffuse {}",
        &[1.0, 0.5, 0.0],
        channels,
        &|diffuse, ray, hit, lights| lambert(color(diffuse), ray, hit, lights),
        &|diffuse, ray, hit, lights| yours(color(diffuse), ray, hit, lights),
    );
    check.scene(&stage(), "lambert", shaded(scenes::lambert(), yours));
}

/// The sum over the lights, with this function of each cosine.
fn textbook(c: &mut Check, share: fn(f64) -> f64) {
    check(c, &|diffuse, ray, hit, lights| {
        sum(diffuse, ray, hit, lights, |light| {
            diffuse * share(hit.normal.dot(light.direction)) * light.color
        })
    });
}

variants! { textbook:
    yours => &lambert;
    right "the share first" => |cosine| cosine.max(0.0);
    wrong "no light is negative" => |cosine| cosine;
}
