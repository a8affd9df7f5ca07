//! Pictures of random greys, compared with the solution.

use crate::prelude::*;

yours! { thumbnail }

type Code = fn(&Image, u32) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    let pictures = Questions {
        words: "a picture of {}x{} with the greys {}, by {}",
        simple: [(2, 2, 2), (4, 1, 3), (1, 4, 3), (2, 2, 1), (2, 2, 5)]
            .map(|(w, h, n)| (w, h, vec![0.0, 1.0, 3.0, 4.0], n))
            .to_vec(),
        others: random(|r| {
            let (w, h, n) = (1 + r.below(7), 1 + r.below(7), 1 + r.below(4));
            (w, h, (0..w * h).map(|_| r.between(0.0, 2.0)).collect(), n)
        }),
        answer: |thumbnail: &Code, (w, h, greys, n): (u32, u32, Vec<f64>, u32)| {
            let color = |x, y| Color::gray(greys[(y * w + x) as usize]);
            let image = Image::from_fn(Size::new(w, h).ok()?, color).ok()?;
            let small = thumbnail(&image, n).ok()?;
            let greys: Vec<f64> = small.pixels().iter().map(|color| color.g).collect();
            let size = Answer::words(small.size().to_string());
            Some(Answer::named("size", size).and("greys", greys))
        },
    };
    Exercise {
        questions: pictures.into(),
        picture: Picture::own(|thumbnail: &Code, _| {
            thumbnail(&ShowImage::test_card()?.into_image(), 4)
        }),
        ..Exercise::default()
    }
}
