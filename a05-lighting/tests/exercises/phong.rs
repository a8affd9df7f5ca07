//! Shiny surfaces, compared with the lesson's.

use crate::prelude::*;

yours! {
    phong => shading(|(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        phong(colors.map(color), exponent, ray, hit, lighting)
    })
}

type Code = Shading<([[f64; 3]; 2], f64)>;
type Other = Variant<Code>;

pub fn phong(
    [diffuse, specular]: [Color; 2],
    exponent: f64,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
) -> Color {
    let shiny = Phong::new(diffuse, specular, exponent);
    shiny.map_or(Color::BLACK, |shiny| shiny.color_for(ray, hit, lighting))
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::scene("phong", |phong: &Code, settings| {
            shaded(scenes::phong()?, settings, |diffuse, ray, hit, lights| {
                let colors = [diffuse.channels(), [1.0; 3]];
                phong((colors, 64.0), ray, hit, lights)
            })
        }),
        right: vec![Other::new(
            "the eye mirrored instead of the light",
            textbook(|is_before, cosine, exponent| is_before * libm::pow(cosine, exponent)),
        )],
        wrong: vec![
            Other::new(
                "light from behind has no highlight",
                textbook(|_, cosine, exponent| libm::pow(cosine, exponent)),
            ),
            Other::new(
                "an exponent may be a fraction",
                textbook(|is_before, cosine, exponent| {
                    is_before * libm::pow(cosine, exponent.trunc())
                }),
            ),
        ],
        ..materials([Materials {
            words: "diffuse and specular {}, exponent {}",
            first: ([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], 2.0),
            any: |r| ([channels(r), channels(r)], r.between(0.5, 40.0)),
        }])
    }
}

/// The sum over the lights, with a highlight that follows from 1 for light from before or
/// 0, the cosine, and the exponent.
fn textbook(highlight: fn(f64, f64, f64) -> f64) -> Code {
    shading(move |(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        let [diffuse, specular] = colors.map(color);
        sum(diffuse, ray, hit, lighting, |light| {
            let (n, l) = (hit.normal, light.direction);
            // The eye is mirrored instead of the light.
            let cosine = l.dot((-ray.direction()).reflected_on(n)).clamp(0.0, 1.0);
            let highlight = highlight(f64::from(n.dot(l) > 0.0), cosine, exponent);
            (diffuse * n.dot(l).max(0.0) + specular * highlight) * light.color
        })
    })
}
