//! Lamps, compared with the solution.

use crate::prelude::*;

yours! { point_light => light_at(|(c, lamp), p| point_light(c, point(lamp), p)) }

type Code = LightAt<(Color, [f64; 3])>;

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong,
        name: "PointLight",
        light: (Color::WHITE, [4.0; 3]),
    };
    Exercise {
        picture: lit.scene("phong"),
        ..lights()
    }
}
