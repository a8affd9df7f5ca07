//! Surfaces that face all directions, compared with the solution.

use std::f64::consts::PI;

use crate::prelude::*;

yours! { hemisphere }

type Code = fn([Color; 3], Normal3) -> Color;
type Other = Variant<Code>;

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
        wrong: vec![
            Other::new("walls see half the sky", |colors, n| {
                mixed(colors, n.y().max(0.0))
            }),
            Other::new("a fraction is between 0 and 1", |colors, n| {
                mixed(colors, n.y())
            }),
            Other::new(
                "the fraction follows from the cosine, not the angle",
                |colors, n| mixed(colors, 1.0 - libm::acos(n.y()) / PI),
            ),
        ],
        ..Exercise::default()
    }
}

/// Sky and ground, with this fraction of the sky.
fn mixed([diffuse, sky, ground]: [Color; 3], fraction: f64) -> Color {
    diffuse * (sky * fraction + ground * (1.0 - fraction))
}
