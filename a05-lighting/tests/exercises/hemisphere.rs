//! Surfaces that face all directions, compared with the solution.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::prelude::*;

yours! { hemisphere => std::sync::Arc::new(hemisphere) }

type Code = Arc<dyn Fn([Color; 3], Normal3) -> Color + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let day = [[1.0, 0.5, 0.25], [0.0, 0.5, 1.0], [0.5, 0.25, 0.0]];
    let normals = [
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.6, 0.8],
        [0.0, -0.6, 0.8],
    ];
    let surfaces = Questions {
        words: "diffuse, sky and ground {}, normal {}".into(),
        simple: normals.map(|n| (day, n)).to_vec(),
        others: random(|r| ([(); 3].map(|()| channels(r)), array(unit(r.triple(1.0))))),
        answer: |hemisphere: &Code, (colors, n): ([_; 3], _)| {
            hemisphere(colors.map(color), unit(n).as_normal()).channels()
        },
    };
    Exercise {
        questions: vec![surfaces.into()],
        picture: Picture::own(|hemisphere: &Code, settings| {
            let [sky, ground] = [[0.8, 0.95, 1.2], [0.3, 0.22, 0.1]].map(color);
            shaded(scenes::lambert()?, settings, |diffuse, _, hit, _| {
                hemisphere([diffuse, sky, ground], hit.normal)
            })
        }),
        wrong: vec![
            Other::new("walls see half the sky", mixed(|cosine| cosine.max(0.0))),
            Other::new("a fraction is between 0 and 1", mixed(|cosine| cosine)),
            Other::new(
                "the fraction follows from the cosine, not the angle",
                mixed(|cosine| 1.0 - libm::acos(cosine) / PI),
            ),
        ],
        ..Exercise::default()
    }
}

/// Sky and ground, with a fraction of the sky that follows from the cosine of the angle to up.
fn mixed(fraction: fn(f64) -> f64) -> Code {
    Arc::new(move |[diffuse, sky, ground]: [_; 3], n: Normal3| {
        diffuse * (sky * fraction(n.y()) + ground * (1.0 - fraction(n.y())))
    })
}
