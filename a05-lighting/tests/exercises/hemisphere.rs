//! Surfaces that face all directions, compared with the solution.

use crate::prelude::*;

yours! { hemisphere }

type Code = fn([Color; 3], Normal3) -> Color;

pub fn exercise() -> Exercise<Code> {
    let day = [
        Color::new(1.0, 0.5, 0.25),
        Color::new(0.0, 0.5, 1.0),
        Color::new(0.5, 0.25, 0.0),
    ];
    let normals = [
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.6, 0.8],
        [0.0, -0.6, 0.8],
    ];
    let surfaces = Questions {
        words: "diffuse, sky and ground {}, normal {}",
        simple: normals.map(|n| (day, n)).to_vec(),
        others: random(|r| ([(); 3].map(|()| r.color()), array(unit(r.triple(1.0))))),
        answer: |hemisphere: &Code, (colors, n): ([_; 3], _)| {
            hemisphere(colors, unit(n).as_normal())
        },
    };
    Exercise {
        questions: surfaces.into(),
        picture: Picture::own(|hemisphere: &Code, settings| {
            let (sky, ground) = (Color::new(0.8, 0.95, 1.2), Color::new(0.3, 0.22, 0.1));
            shaded(scenes::lambert()?, settings, |diffuse, _, hit, _| {
                hemisphere([diffuse, sky, ground], hit.normal)
            })
        }),
        ..Exercise::default()
    }
}
