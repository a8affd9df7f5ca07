//! Surfaces that face all directions, compared with the solution.

use crate::prelude::*;

yours! { hemisphere }

type Code = fn([Color; 3], Normal3) -> Color;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|hemisphere: &Code, settings| {
            let (sky, ground) = (Color::new(0.8, 0.95, 1.2), Color::new(0.3, 0.22, 0.1));
            shaded(scenes::lambert()?, settings, |diffuse, _, hit, _| {
                hemisphere([diffuse, sky, ground], hit.normal)
            })
        }),
        ..Exercise::asked(|hemisphere: &Code, (colors, n): ([_; 3], _)| {
            hemisphere(colors, unit(n).as_normal()).channels()
        })
    }
}
