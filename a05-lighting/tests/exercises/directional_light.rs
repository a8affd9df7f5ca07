//! Far lights, compared with the solution.

use crate::prelude::*;

yours! {
    directional_light => light_at(|(c, direction), _| {
        directional_light(c, vector(direction))
    })
}

type Code = LightAt<(Color, [f64; 3])>;

const COLOR: Color = Color::new(1.0, 0.5, 0.25);

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_directional,
        name: "DirectionalLight",
        light: (Color::WHITE, [-1.0; 3]),
    };
    Exercise {
        picture: lit.scene("phong-directional"),
        ..lights([Lights {
            words: "light {} that travels along {}",
            first: (COLOR, [0.0, -2.0, 0.0]),
            simple: vec![
                ((COLOR, [0.0; 3]), LAMP),
                ((COLOR, [0.0, -1e-18, 0.0]), LAMP),
                ((COLOR, [0.0, -1e18, 0.0]), LAMP),
            ],
            others: vec![],
            any: |r| {
                let length = r.scale();
                (r.color(), r.triple(5.0).map(|x| x * length))
            },
        }])
    }
}
