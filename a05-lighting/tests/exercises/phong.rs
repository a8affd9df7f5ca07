//! Shiny surfaces, compared with the solution.

use crate::prelude::*;

yours! {
    phong => shading(|(colors, exponent): ([_; 2], _), ray, hit, lighting| {
        phong(colors, exponent, ray, hit, lighting)
    })
}

type Code = Shading<([Color; 2], f64)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("phong", |phong: &Code, settings| {
            shaded(scenes::phong()?, settings, |diffuse, ray, hit, lights| {
                phong(([diffuse, Color::WHITE], 64.0), ray, hit, lights)
            })
        }),
        ..materials()
    }
}
