//! Files of pictures of random bytes, compared with the solution.

use crate::prelude::*;

yours! { ppm }

type Code = fn(&Image) -> Vec<u8>;

pub fn exercise() -> Exercise<Code> {
    let of_bytes = Form::new(|ppm: &Code, (w, h, bytes): (u32, u32, Vec<u8>)| {
        let rgb = |x, y| [0, 1, 2].map(|i| bytes[(3 * (y * w + x) + i) as usize]);
        let image = Image::from_fn(Size::new(w, h).ok()?, |x, y| Color::from_bytes(rgb(x, y)));
        Some(Answer::words(ppm(&image.ok()?).escape_ascii().to_string()))
    });
    let between_bytes = Form::new(|ppm: &Code, grey| {
        let image = Image::from_fn(Size::new(1, 1).ok()?, |_, _| Color::gray(grey));
        Some(Answer::words(ppm(&image.ok()?).escape_ascii().to_string()))
    });
    Exercise {
        forms: vec![of_bytes, between_bytes],
        ..Exercise::default()
    }
}
