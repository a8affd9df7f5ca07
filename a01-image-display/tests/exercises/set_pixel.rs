//! Places in pictures and beside them, compared with the solution.

use crate::prelude::*;

yours! { set_pixel }

type Code = fn(&mut Image, u32, u32, Color);

pub fn exercise() -> Exercise<Code> {
    let red = Form::new(|set_pixel: &Code, (w, h, x, y)| {
        painted((w, h), |size| {
            let mut image = Image::from_fn(size, |_, _| Color::BLUE)?;
            set_pixel(&mut image, x, y, Color::RED);
            Ok(image)
        })
    });
    let colors = Form::new(
        |set_pixel: &Code, (color, paper, x, y): (String, String, _, _)| {
            let [color, paper] = [color, paper].map(|name| match &*name {
                "green" => Color::GREEN,
                "blue" => Color::BLUE,
                _ => Color::BLACK,
            });
            painted((4, 3), |size| {
                let mut image = Image::from_fn(size, |_, _| paper)?;
                set_pixel(&mut image, x, y, color);
                Ok(image)
            })
        },
    );
    let pictures = Form::new(|set_pixel: &Code, places: Vec<[u32; 2]>| {
        painted((5, 4), |size| {
            let mut image = Image::black(size)?;
            let colors = [Color::RED, Color::GREEN, Color::BLUE].into_iter().cycle();
            for ([x, y], color) in places.iter().zip(colors) {
                set_pixel(&mut image, *x, *y, color);
            }
            Ok(image)
        })
    });
    // A picture may have more light than a screen shows.
    let light = Form::new(|set_pixel: &Code, color| {
        let mut image = Image::black(Size::new(1, 1).ok()?).ok()?;
        set_pixel(&mut image, 0, 0, color);
        image.get(0, 0)
    });
    Exercise {
        forms: vec![red, colors, pictures, light],
        picture: StudentPicture::own(boat),
        ..Exercise::default()
    }
}

/// A boat of few pixels: w is a pixel of the sail, b of the hull, and o of the sea.
const BOAT: [&str; 12] = [
    "",
    "        w",
    "        ww",
    "        www",
    "        wwww",
    "        wwwww",
    "        wwwwww",
    "        b",
    "   bbbbbbbbbbbb",
    "    bbbbbbbbbb",
    "oooooooooooooooo",
    "oooooooooooooooo",
];

/// The boat, with pixels as large as squares. Red squares are pixels that lie outside of the
/// picture, and must not be seen.
fn boat(set_pixel: &Code, settings: &Settings) -> Result<Image, Error> {
    let mut small = Image::black(Size::new(16, 12)?)?;
    for (y, row) in (0..).zip(BOAT) {
        for (x, letter) in (0..).zip(row.chars()) {
            let color = match letter {
                'w' => Color::WHITE,
                'b' => Color::new(0.6, 0.3, 0.1),
                'o' => Color::new(0.1, 0.3, 0.7),
                _ => continue,
            };
            set_pixel(&mut small, x, y, color);
        }
    }
    for y in 1..4 {
        set_pixel(&mut small, 17, y, Color::RED);
        set_pixel(&mut small, y, 12, Color::RED);
    }
    let squares = settings.size.width() / small.size().width();
    Image::from_fn(settings.size, |x, y| {
        let is_gap = x % squares == 0 || y % squares == 0;
        let color = small.get(x / squares, y / squares).unwrap_or_default();
        if is_gap { color * 0.7 } else { color }
    })
}
