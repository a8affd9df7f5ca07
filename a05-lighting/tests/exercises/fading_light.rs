//! Lamps of many colours, compared with the solution.

use crate::prelude::*;

yours! { fading_light => light_at(|(c, lamp), p| fading_light(c, point(lamp), p)) }

type Code = LightAt<(Color, [f64; 3])>;

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong,
        name: "",
        light: (Color::gray(2.5), [0.2, 2.2, 1.5]),
    };
    Exercise {
        picture: lit.own(),
        ..lights()
    }
}
