//! Shiny surfaces, compared with the solution.

use crate::prelude::*;

yours! { blinn_phong => crate::blinn_phong::summed(blinn_phong) }

type Code = Shading<([Color; 2], f64)>;

/// The reflected light of one lamp, by the colours, the exponent, the ray, its hit, and the light.
type OfLamp = fn([Color; 2], f64, &Ray, &Hit, &Illumination) -> Color;

/// The ambient light, and the light of all lamps.
pub fn summed(of_lamp: OfLamp) -> Code {
    shading(move |(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        sum(colors[0], ray, hit, lighting, |light| {
            of_lamp(colors, exponent, ray, hit, light)
        })
    })
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|blinn_phong: &Code, settings| {
            shaded(scenes::phong()?, settings, |diffuse, ray, hit, lights| {
                blinn_phong(([diffuse, Color::gray(0.7)], 64.0), ray, hit, lights)
            })
        }),
        ..materials()
    }
}
