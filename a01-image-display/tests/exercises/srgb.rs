//! Light and values on both parts of the curve, compared with the solution.

use crate::prelude::*;

yours! { encode, decode => crate::srgb::Code { encode, decode } }

#[derive(Clone, Copy)]
pub struct Code {
    pub encode: fn(f64) -> f64,
    pub decode: fn(f64) -> f64,
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        forms: vec![
            Form::new(|code: &Code, light: f64| (code.encode)(light)),
            Form::new(|code: &Code, value: f64| (code.decode)(value)),
        ],
        picture: StudentPicture::own(test_card),
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
