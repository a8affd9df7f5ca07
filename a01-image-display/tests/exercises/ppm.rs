//! Files of pictures of random bytes, compared with the solution.

use crate::prelude::*;

yours! { ppm }

type Code = fn(&Image) -> Vec<u8>;

pub fn exercise() -> Exercise<Code> {
    let pictures = Questions {
        words: "a picture of {}x{} with the bytes {}",
        simple: vec![(1, 1, b"RGB".to_vec()), (2, 1, b"red\n\r ".to_vec())],
        others: random(|r| {
            let (w, h) = (1 + r.below(4), 1 + r.below(4));
            (w, h, (0..3 * w * h).map(|_| r.below(256) as u8).collect())
        }),
        answer: |ppm: &Code, (w, h, bytes): (u32, u32, Vec<u8>)| {
            let rgb = |x, y| [0, 1, 2].map(|i| bytes[(3 * (y * w + x) + i) as usize]);
            let image = Image::from_fn(Size::new(w, h).ok()?, |x, y| Color::from_bytes(rgb(x, y)));
            Some(Answer::words(ppm(&image.ok()?).escape_ascii().to_string()))
        },
    };
    let between_bytes = Questions {
        words: "a picture of one pixel of the grey {}",
        simple: vec![0.999, 0.5, 0.25, 2.0, -1.0],
        others: vec![],
        answer: |ppm: &Code, grey| {
            let image = Image::from_fn(Size::new(1, 1).ok()?, |_, _| Color::gray(grey));
            Some(Answer::words(ppm(&image.ok()?).escape_ascii().to_string()))
        },
    };
    Exercise {
        questions: all([pictures.into(), between_bytes.into()]),
        ..Exercise::default()
    }
}
