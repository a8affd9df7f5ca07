//! Lamps between mirrors, compared with the solution.

use crate::prelude::*;

yours! { images }

/// The images in both mirrors: by their distance, the place of the lamp, and the reflections.
type Code = fn(f64, f64, u32) -> [f64; 2];

pub fn exercise() -> Exercise<Code> {
    let lamps = Questions {
        words: "mirrors {} apart, lamp at {}, after {} reflections",
        simple: [0, 1, 2, 3].map(|n| (10.0, 3.0, n)).to_vec(),
        others: random(|r| {
            let width = r.between(1.0, 20.0);
            (width, r.between(0.0, width), r.below(12))
        }),
        answer: |images: &Code, (width, lamp, n)| images(width, lamp, n),
    };
    Exercise {
        questions: lamps.into(),
        ..Exercise::default()
    }
}
