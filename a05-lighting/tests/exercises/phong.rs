//! Shiny surfaces, compared with the lesson's.

use crate::prelude::*;

pub fn phong([d, s]: [Color; 2], p: f64, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let shiny = Phong::new(d, s, p);
    shiny.map_or(Color::BLACK, |shiny| shiny.color_for(ray, hit, lighting))
}

pub fn check(
    check: &mut Check,
    yours: &(dyn Fn([Color; 2], f64, &Ray, &Hit, &dyn Lighting) -> Color + Sync),
) {
    compare_materials(
        check,
        "diffuse and specular {}, exponent {}",
        &([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], 2.0),
        |r| ([channels(r), channels(r)], r.between(0.5, 40.0)),
        &|(colors, p), ray, hit, lights| phong(colors.map(color), p, ray, hit, lights),
        &|(colors, p), ray, hit, lights| yours(colors.map(color), p, ray, hit, lights),
    );
    let picture = shaded(scenes::phong(), |d, ray, hit, lights| {
        yours([d, Color::WHITE], 64.0, ray, hit, lights)
    });
    check.scene(&stage(), "phong", picture);
}

/// The sum over the lights, with a highlight that follows from 1 for light from before or
/// 0, the cosine, and the exponent.
fn textbook(c: &mut Check, highlight: fn(f64, f64, f64) -> f64) {
    check(c, &|[diffuse, specular], p, ray, hit, lights| {
        sum(diffuse, ray, hit, lights, |light| {
            let (n, l) = (hit.normal, light.direction);
            // The eye mirrored in the place of the light.
            let cosine = l.dot((-ray.direction()).reflected_on(n)).clamp(0.0, 1.0);
            let highlight = highlight(f64::from(n.dot(l) > 0.0), cosine, p);
            (diffuse * n.dot(l).max(0.0) + specular * highlight) * light.color
        })
    });
}

variants! { textbook:
    yours => &phong;
    right "the eye mirrored in the place of the light" => |is_before, cosine, p| {
        is_before * libm::pow(cosine, p)
    };
    wrong "light from behind has no highlight" => |_, cosine, p| libm::pow(cosine, p);
    wrong "an exponent may be a fraction" => |is_before, cosine, p| {
        is_before * libm::pow(cosine, p.trunc())
    };
}
