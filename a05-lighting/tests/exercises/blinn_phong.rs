//! Shiny surfaces, compared with the solution.

use crate::prelude::*;

type Shiny = fn([Color; 2], f64, &Ray, &Hit, &Illumination) -> Color;

pub fn check(check: &mut Check, yours: Shiny) {
    let all = |of: Shiny, colors: [Color; 2], p, ray: &Ray, hit: &Hit, lights: &dyn Lighting| {
        sum(colors[0], ray, hit, lights, |light| {
            of(colors, p, ray, hit, light)
        })
    };
    for p in [2.0, 0.0] {
        compare_materials(
            check,
            "diffuse and specular {}, exponent {}",
            &([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], p),
            |r| ([channels(r), channels(r)], r.between(0.5, 40.0)),
            &|(cs, p), ray, hit, lights| all(blinn_phong, cs.map(color), p, ray, hit, lights),
            &|(cs, p), ray, hit, lights| all(yours, cs.map(color), p, ray, hit, lights),
        );
    }
    check.picture(shaded(scenes::phong(), |diffuse, ray, hit, lights| {
        let colors = [diffuse, Color::gray(0.7)];
        all(yours, colors, 64.0, ray, hit, lights)
    }));
}

variants! { check:
    yours => blinn_phong;
    wrong "the vector half way has length 1" => |[cd, cs], p, ray, hit, light| {
        let half = (light.direction - ray.direction()) * 0.5;
        let [cosine, highlight] = [light.direction, half].map(|d| hit.normal.dot(d).max(0.0));
        let is_before = f64::from(cosine > 0.0);
        (cd * cosine + cs * (is_before * libm::pow(highlight, p))) * light.color
    };
}
