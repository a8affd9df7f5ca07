//! Matt surfaces, compared with the solution.

use crate::prelude::*;

yours! {
    lambert => shading(lambert)
}

type Code = Shading<Color>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::scene("lambert", |lambert: &Code, settings| {
            shaded(scenes::lambert()?, settings, |diffuse, ray, hit, lights| {
                lambert(diffuse, ray, hit, lights)
            })
        }),
        wrong: vec![
            Other::new("no light is negative", textbook(|cosine| cosine)),
            Other::new(
                "light along the surface adds nothing",
                textbook(|cosine| 0.5 * cosine + 0.5),
            ),
        ],
        ..materials([Materials {
            words: "diffuse {}",
            first: Color::new(1.0, 0.5, 0.0),
            any: Random::color,
        }])
    }
}

/// The sum over the lights, with a fraction that follows from each cosine.
fn textbook(fraction: fn(f64) -> f64) -> Code {
    shading(move |diffuse, ray, hit, lighting| {
        sum(diffuse, ray, hit, lighting, |light| {
            diffuse * fraction(hit.normal.dot(light.direction)) * light.color
        })
    })
}
