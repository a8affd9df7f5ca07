//! Light and values on both parts of the curve, compared with the solution.

use crate::prelude::*;

yours! { encode, decode => crate::srgb::Code { encode, decode } }

#[derive(Clone, Copy)]
pub struct Code {
    pub encode: fn(f64) -> f64,
    pub decode: fn(f64) -> f64,
}

pub fn exercise() -> Exercise<Code> {
    let simple = vec![1.0, 0.0, 0.5, 0.02, 0.002, 0.0031, 0.0032, 0.04, 0.041];
    // Above and below the border between both parts.
    let others = random(|r| r.between(0.0, 1.0) * [1.0, 0.01][r.below(2) as usize]);
    let lights = Questions {
        words: "the light {}",
        simple: simple.clone(),
        others: others.clone(),
        answer: |code: &Code, light| (code.encode)(light),
    };
    let values = Questions {
        words: "the value {}",
        simple,
        others,
        answer: |code: &Code, value| (code.decode)(value),
    };
    Exercise {
        questions: all([lights.into(), values.into()]),
        picture: Picture::own(test_card),
        ..Exercise::default()
    }
}

/// Greys in even steps, as they are and encoded, above lines of black and white.
fn test_card(code: &Code, settings: &Settings) -> Result<Image, Error> {
    let (width, height) = (settings.size.width(), settings.size.height());
    Image::from_fn(settings.size, |x, y| {
        let step = f64::from(x * 8 / width) / 7.0;
        Color::gray(match y * 3 / height {
            0 => step,
            1 => (code.encode)(step),
            _ if x * 3 / width == 1 => f64::from(y % 2),
            _ => (code.encode)(0.5),
        })
    })
}
