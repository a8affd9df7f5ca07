//! Lamps between mirrors, compared with the solution.

use crate::prelude::*;

yours! { images }

/// The images in both mirrors: by their distance, the place of the lamp, and the reflections.
type Code = fn(f64, f64, u32) -> [f64; 2];
type Other = Variant<Code>;

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
        wrong: vec![
            Other::new(
                "a mirror shows the image in the other one",
                |width, lamp, n| steps(lamp, n, |[left, right]| [-left, 2.0 * width - right]),
            ),
            Other::new("a mirror at x = m moves x to 2m - x", |width, lamp, n| {
                steps(lamp, n, |[left, right]| [-right, width - left])
            }),
            Other::new("both images are replaced at once", |width, lamp, n| {
                steps(lamp, n, |[_, right]| [-right, 2.0 * width + right])
            }),
        ],
        ..Exercise::default()
    }
}

/// Images of which each step makes the next ones.
fn steps(lamp: f64, n: u32, step: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let mut images = [lamp; 2];
    for _ in 0..n {
        images = step(images);
    }
    images
}
