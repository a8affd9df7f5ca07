//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { line }

type Code = fn(Size) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    // With an odd number of steps, the line never passes half way between two pixels, where
    // both are right.
    let mut sizes = random(|r| (1 + r.below(24), 1 + r.below(24)));
    sizes.retain(|(w, h)| w.max(h) % 2 == 0);
    let pictures = Questions {
        words: "a picture of {}x{}",
        simple: vec![(3, 3), (4, 2), (2, 4), (6, 3), (1, 1), (4, 1), (1, 4)],
        others: sizes,
        answer: |line: &Code, size| painted(size, line),
    };
    Exercise {
        questions: pictures.into(),
        picture: Picture::own(|line: &Code, settings| line(settings.size)),
        ..Exercise::default()
    }
}
