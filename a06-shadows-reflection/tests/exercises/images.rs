//! Lamps between mirrors, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { images => std::sync::Arc::new(images) }

/// The images in both mirrors: by their distance, the place of the lamp, and the reflections.
type Code = Arc<dyn Fn(f64, f64, u32) -> [f64; 2] + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let lamps = Questions {
        words: "mirrors {} apart, lamp at {}, after {} reflections".into(),
        simple: [0, 1, 2, 3].map(|n| (10.0, 3.0, n)).to_vec(),
        others: random(|r| {
            let width = r.between(1.0, 20.0);
            (width, r.between(0.0, width), r.below(12))
        }),
        answer: |images: &Code, (width, lamp, n)| images(width, lamp, n),
    };
    Exercise {
        questions: vec![lamps.into()],
        wrong: vec![
            Other::new(
                "a mirror shows the image in the other one",
                steps(|width, [left, right]| [-left, 2.0 * width - right]),
            ),
            Other::new(
                "a mirror at x = m moves x to 2m - x",
                steps(|width, [left, right]| [-right, width - left]),
            ),
            Other::new(
                "both images are replaced at once",
                steps(|width, [_, right]| [-right, 2.0 * width + right]),
            ),
        ],
        ..Exercise::default()
    }
}

/// Images of which each step makes the next ones, by the distance of the mirrors.
fn steps(step: fn(f64, [f64; 2]) -> [f64; 2]) -> Code {
    Arc::new(move |width, lamp, n| {
        let mut images = [lamp; 2];
        for _ in 0..n {
            images = step(width, images);
        }
        images
    })
}
