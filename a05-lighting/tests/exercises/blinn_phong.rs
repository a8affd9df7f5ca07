//! Shiny surfaces, compared with the solution.

use crate::prelude::*;

yours! { blinn_phong => crate::blinn_phong::summed(blinn_phong) }

type Code = Shading<([[f64; 3]; 2], f64)>;
type Other = Variant<Code>;

/// The reflected light of one lamp, by the colours, the exponent, the ray, its hit, and the light.
type OfLamp = fn([Color; 2], f64, &Ray, &Hit, &Illumination) -> Color;

/// The ambient light, and the light of all lamps.
pub fn summed(of_lamp: OfLamp) -> Code {
    shading(move |(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        let colors = colors.map(color);
        sum(colors[0], ray, hit, lighting, |light| {
            of_lamp(colors, exponent, ray, hit, light)
        })
    })
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::own(|blinn_phong: &Code, settings| {
            shaded(scenes::phong()?, settings, |diffuse, ray, hit, lights| {
                let colors = [diffuse.channels(), [0.7; 3]];
                blinn_phong((colors, 64.0), ray, hit, lights)
            })
        }),
        wrong: vec![Other::new(
            "the vector half way has length 1",
            summed(not_normalized),
        )],
        ..materials([2.0, 0.0].map(|exponent| Materials {
            words: "diffuse and specular {}, exponent {}",
            first: ([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], exponent),
            any: |r| ([channels(r), channels(r)], r.between(0.5, 40.0)),
        }))
    }
}

fn not_normalized(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> Color {
    let half = (light.direction - ray.direction()) * 0.5;
    let [cosine, highlight] = [light.direction, half].map(|d| hit.normal.dot(d).max(0.0));
    let is_before = f64::from(cosine > 0.0);
    let specular = specular * (is_before * libm::pow(highlight, exponent));
    (diffuse * cosine + specular) * light.color
}
