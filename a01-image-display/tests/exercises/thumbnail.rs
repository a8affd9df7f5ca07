//! Pictures of random greys, compared with the solution.

use crate::prelude::*;

yours! { thumbnail }

type Code = fn(&Image, u32) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    let small = |thumbnail: &Code, (w, h, greys, n): (u32, u32, Vec<f64>, u32)| {
        let color = |x, y| Color::gray(greys[(y * w + x) as usize]);
        let image = Image::from_fn(Size::new(w, h).ok()?, color).ok()?;
        let small = thumbnail(&image, n).ok()?;
        let greys: Vec<f64> = small.pixels().iter().map(|color| color.g).collect();
        let size = Answer::words(small.size().to_string());
        Some(Answer::named("size", size).and("greys", greys))
    };
    Exercise {
        picture: StudentPicture::own(|thumbnail: &Code, _| {
            thumbnail(&ShowImage::test_card()?.into_image(), 4)
        }),
        ..Exercise::asked(small)
    }
}
