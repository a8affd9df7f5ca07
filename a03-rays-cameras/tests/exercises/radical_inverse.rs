//! Numbers in many bases, compared with the solution.

use crate::prelude::*;

yours! { radical_inverse }

type Code = fn(u32, u32) -> f64;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(points),
        ..Exercise::asked(|radical_inverse: &Code, (n, base)| radical_inverse(n, base))
    }
}

/// The points whose coordinates are the numbers in base 2 and in base 3.
fn points(radical_inverse: &Code, settings: &Settings) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let (width, height) = (settings.size.width(), settings.size.height());
    for n in 0..1500 {
        let x = radical_inverse(n, 2) * f64::from(width);
        let y = radical_inverse(n, 3) * f64::from(height);
        image.set(x as u32, y as u32, Color::WHITE);
    }
    Ok(image)
}
