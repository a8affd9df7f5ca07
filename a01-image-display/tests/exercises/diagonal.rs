//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { diagonal }

type Code = fn(Size) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    let pictures = Questions {
        words: "a picture of {}x{}",
        simple: vec![(3, 3), (5, 3), (3, 5), (1, 1)],
        others: random(|r| (1 + r.below(12), 1 + r.below(12))),
        answer: |diagonal: &Code, size| painted(size, diagonal),
    };
    Exercise {
        questions: pictures.into(),
        picture: Picture::scene("diagonal", |diagonal: &Code, settings| {
            diagonal(settings.size)
        }),
        ..Exercise::default()
    }
}
