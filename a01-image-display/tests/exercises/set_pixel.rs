//! Places in pictures and beside them, compared with the lesson's `Image::set`.

use crate::prelude::*;

pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    image.set(x, y, color);
}

pub fn check(check: &mut Check, yours: &dyn Fn(&mut Image, u32, u32, Color)) {
    check.compare(
        "a picture of {}x{}, column {}, row {}",
        [(4, 3, 0, 0), (4, 3, 2, 1), (3, 4, 1, 2), (4, 3, 4, 0)],
        random(|r| (1 + r.below(9), 1 + r.below(9), r.below(9), r.below(9))),
        [&set_pixel as _, yours],
        |set_pixel, (w, h, x, y)| {
            painted((w, h), |size| {
                let mut image = Image::black(size)?;
                set_pixel(&mut image, x, y, Color::RED);
                Ok(image)
            })
        },
    );
    check.scene(&stage(), "diagonal", |settings| {
        let mut image = Image::black(settings.size)?;
        (0..settings.size.width()).for_each(|at| yours(&mut image, at, at, Color::RED));
        Ok(image)
    });
}

/// Paints the pixel at an index that follows from x, y, width and height.
fn indexed(index: fn(u32, u32, u32, u32) -> u32) -> impl Fn(&mut Image, u32, u32, Color) {
    move |image, x, y, color| {
        let index = index(x, y, image.size().width(), image.size().height());
        if let Some(pixel) = image.pixels_mut().get_mut(index as usize) {
            *pixel = color;
        }
    }
}

variants! { check:
    yours => &set_pixel;
    right "a pixel of a row" => &|image, x, y, color| {
        let row = image.rows_mut().nth(y as usize);
        if let Some(pixel) = row.and_then(|row| row.get_mut(x as usize)) {
            *pixel = color;
        }
    };
    wrong "x beyond the width is no pixel of the next row" => &indexed(|x, y, w, _| y * w + x);
    wrong "a row is as long as the picture is wide" => &indexed(|x, y, _, h| y * h + x);
    wrong "the list is row after row, not column by column" => &indexed(|x, y, _, h| x * h + y);
}
