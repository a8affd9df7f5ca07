//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { diagonal }

type Code = fn(Size) -> Result<Image, Error>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let pictures = Questions {
        words: "a picture of {}x{}",
        simple: vec![(3, 3), (5, 3), (3, 5), (1, 1)],
        others: random(|r| (1 + r.below(12), 1 + r.below(12))),
        answer: |diagonal: &Code, size| painted(size, diagonal),
    };
    Exercise {
        questions: pictures.into(),
        picture: Picture::scene("diagonal", |diagonal: &Code, settings| {
            diagonal(settings.size)
        }),
        wrong: vec![
            Other::new("the line is not stretched to the corner", |size| {
                red(size, |[x, y], [w, h]| x * h == y * w)
            }),
            Other::new("rows are counted from the top", |size| {
                red(size, |[x, y], [_, h]| x + y + 1 == h)
            }),
            Other::new("the last row counts, too", |size| {
                red(size, |[x, y], [_, h]| x == y && y + 1 < h)
            }),
        ],
        ..Exercise::default()
    }
}

/// Red in column x and row y of a picture of this width and height.
fn red(size: Size, is_red: fn([u32; 2], [u32; 2]) -> bool) -> Result<Image, Error> {
    Image::from_fn(size, |x, y| {
        if is_red([x, y], [size.width(), size.height()]) {
            Color::RED
        } else {
            Color::BLACK
        }
    })
}
