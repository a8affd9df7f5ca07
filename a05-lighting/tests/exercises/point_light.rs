//! Lamps, compared with the solution.

use crate::prelude::*;

yours! { point_light => light_at(|(c, lamp), p| point_light(c, point(lamp), p)) }

type Code = LightAt<(Color, [f64; 3])>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong,
        name: "PointLight",
        light: (Color::WHITE, [4.0; 3]),
    };
    Exercise {
        picture: lit.scene("phong"),
        wrong: vec![Other::from_right(
            "this lamp is as bright at every distance",
            |right| {
                light_at(move |parameters, p| {
                    let light = right(parameters, p)?;
                    let square = light.distance * light.distance;
                    Some(Illumination {
                        color: light.color * (1.0 / square),
                        ..light
                    })
                })
            },
        )],
        ..lights([Lights {
            words: "light {} at {}",
            first: (Color::new(1.0, 0.5, 0.25), LAMP),
            simple: vec![],
            others: vec![],
            any: |r| (r.color(), r.triple(5.0)),
        }])
    }
}
