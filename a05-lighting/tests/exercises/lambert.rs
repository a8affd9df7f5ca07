//! Matt surfaces, compared with the solution.

use crate::prelude::*;

yours! {
    lambert => shading(|diffuse, ray, hit, lighting| lambert(color(diffuse), ray, hit, lighting))
}

type Code = Shading<[f64; 3]>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::scene("lambert", |lambert: &Code, settings| {
            shaded(scenes::lambert()?, settings, |diffuse, ray, hit, lights| {
                lambert(diffuse.channels(), ray, hit, lights)
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
            first: [1.0, 0.5, 0.0],
            any: channels,
        }])
    }
}

/// The sum over the lights, with a fraction that follows from each cosine.
fn textbook(fraction: fn(f64) -> f64) -> Code {
    shading(move |diffuse, ray, hit, lighting| {
        let diffuse = color(diffuse);
        sum(diffuse, ray, hit, lighting, |light| {
            diffuse * fraction(hit.normal.dot(light.direction)) * light.color
        })
    })
}
