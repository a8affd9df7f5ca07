//! Places in pictures and beside them, compared with the lesson's `Image::set`.

use crate::prelude::*;

yours! { set_pixel }

type Code = fn(&mut Image, u32, u32, Color);
type Other = Variant<Code>;

pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    image.set(x, y, color);
}

pub fn exercise() -> Exercise<Code> {
    let places = Questions {
        words: "a picture of {}x{}, column {}, row {}".into(),
        simple: vec![(4, 3, 0, 0), (4, 3, 2, 1), (3, 4, 1, 2), (4, 3, 4, 0)],
        others: random(|r| (1 + r.below(9), 1 + r.below(9), r.below(9), r.below(9))),
        answer: |set_pixel: &Code, (w, h, x, y)| {
            painted((w, h), |size| {
                let mut image = Image::black(size)?;
                set_pixel(&mut image, x, y, Color::RED);
                Ok(image)
            })
        },
    };
    Exercise {
        questions: vec![places.into()],
        picture: Picture::scene("diagonal", |set_pixel: &Code, settings| {
            let mut image = Image::black(settings.size)?;
            for at in 0..settings.size.width() {
                set_pixel(&mut image, at, at, Color::RED);
            }
            Ok(image)
        }),
        right: vec![Other::new("a pixel of a row", pixel_of_row)],
        wrong: vec![
            Other::new(
                "x beyond the width is no pixel of the next row",
                |image, x, y, color| set(image, color, |w, _| y * w + x),
            ),
            Other::new(
                "a row is as long as the picture is wide",
                |image, x, y, color| set(image, color, |_, h| y * h + x),
            ),
            Other::new(
                "the list is row after row, not column by column",
                |image, x, y, color| set(image, color, |_, h| x * h + y),
            ),
        ],
        ..Exercise::default()
    }
}

fn pixel_of_row(image: &mut Image, x: u32, y: u32, color: Color) {
    let row = image.rows_mut().nth(y as usize);
    if let Some(pixel) = row.and_then(|row| row.get_mut(x as usize)) {
        *pixel = color;
    }
}

/// Paints the pixel at an index that follows from width and height.
fn set(image: &mut Image, color: Color, index: impl Fn(u32, u32) -> u32) {
    let index = index(image.size().width(), image.size().height());
    if let Some(pixel) = image.pixels_mut().get_mut(index as usize) {
        *pixel = color;
    }
}
