//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { line }

type Code = fn(Size) -> Result<Image, Error>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    // With an odd number of steps, the line never passes half way between two pixels, where
    // both are right.
    let mut sizes = random(|r| (1 + r.below(24), 1 + r.below(24)));
    sizes.retain(|(w, h)| w.max(h) % 2 == 0);
    let pictures = Questions {
        words: "a picture of {}x{}",
        simple: vec![(3, 3), (4, 2), (2, 4), (6, 3), (1, 1), (4, 1), (1, 4)],
        others: sizes,
        answer: |line: &Code, size| painted(size, line),
    };
    Exercise {
        questions: pictures.into(),
        picture: Picture::own(|line: &Code, settings| line(settings.size)),
        wrong: vec![
            Other::new("a high picture has a pixel in every row", |size| {
                steps(size, |right, _| right, nearest)
            }),
            Other::new("the nearest pixel need not be the one below", |size| {
                steps(size, u32::max, |i, length, steps| i * length / steps)
            }),
            Other::new("a slope is no whole number", |size| {
                steps(size, u32::max, |i, length, steps| i * (length / steps))
            }),
        ],
        ..Exercise::default()
    }
}

fn nearest(i: u32, length: u32, steps: u32) -> u32 {
    (i * length + steps / 2) / steps
}

/// Steps from corner to corner, whose number follows from the last column and row; and the
/// place on a side after i of them.
fn steps(
    size: Size,
    count: fn(u32, u32) -> u32,
    place: fn(u32, u32, u32) -> u32,
) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    let (right, bottom) = (size.width() - 1, size.height() - 1);
    let steps = count(right, bottom);
    for i in 0..=steps {
        let [x, up] = [right, bottom].map(|length| place(i, length, steps.max(1)));
        image.set(x, bottom.saturating_sub(up), Color::BLUE);
    }
    Ok(image)
}
