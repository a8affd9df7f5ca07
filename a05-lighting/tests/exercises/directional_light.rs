//! Far lights, compared with the solution.

use crate::prelude::*;

yours! {
    directional_light => light_at(|(c, direction), _| {
        directional_light(c, vector(direction))
    })
}

type Code = LightAt<(Color, [f64; 3])>;

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_directional,
        name: "DirectionalLight",
        light: (Color::WHITE, [-1.0; 3]),
    };
    Exercise {
        picture: lit.scene("phong-directional"),
        ..lights()
    }
}
